// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a text is as a JSON schema of etc/misfit requires.

#include "jsonSchema.H"
#include "templates.H"

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <sstream>

nlohmann::json Foam::schemaOf(const std::string& file)
{
    return nlohmann::json::parse(misfit::templateText(word(file)));
}


std::string Foam::schemaErrors(const std::string& file, const nlohmann::json& record)
{
    using adapter = valijson::adapters::NlohmannJsonAdapter;
    const nlohmann::json text(schemaOf(file));
    valijson::Schema schema;
    valijson::SchemaParser(valijson::SchemaParser::kDraft7)
        .populateSchema(adapter(text), schema);
    valijson::ValidationResults results;
    valijson::Validator().validate(schema, adapter(record), &results);
    std::ostringstream os;
    for (const auto& error : results)
    {
        for (const std::string& part : error.context)
        {
            os << part;
        }
        os << ": " << error.description << '\n';
    }
    return os.str();
}


void Foam::expectOfSchema(const std::string& file, const nlohmann::json& record)
{
    EXPECT_EQ(schemaErrors(file, record), "");
    for (const nlohmann::json& key : schemaOf(file)["required"])
    {
        nlohmann::json without(record);
        EXPECT_EQ(without.erase(key.get<std::string>()), 1) << key;
        EXPECT_NE(schemaErrors(file, without), "") << key;
    }
    nlohmann::json with(record);
    with["another"] = 1;
    EXPECT_NE(schemaErrors(file, with), "");
}
