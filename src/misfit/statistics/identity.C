// SPDX-License-Identifier: GPL-3.0-or-later

#include "identity.H"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace statistics
{

identity::identity(const std::string& quantity, const std::string& formula)
:
    formula_(new mu::Parser),
    columns_(1, quantity)
{
    try
    {
        formula_->SetExpr(formula);
        for (const auto& used : formula_->GetUsedVar())
        {
            columns_.push_back(used.first);
        }
        variables_ = vec::Constant(count(columns_), 1);
        for (int i = 1; i < count(columns_); ++i)
        {
            formula_->DefineVar(columns_[i], &variables_[i]);
        }
        value(variables_);
    }
    catch (const mu::Parser::exception_type& wrong)
    {
        throw std::invalid_argument
        (
            "the formula \"" + formula + "\": " + wrong.GetMsg()
        );
    }
    if
    (
        columns_.size() < 2
     || std::count(columns_.begin(), columns_.end(), quantity) > 1
    )
    {
        throw std::invalid_argument
        (
            "the formula \"" + formula + "\" needs columns other than "
          + quantity
        );
    }
}


identity::~identity() = default;


double identity::value(const vec& row)
{
    variables_ = row;
    return formula_->Eval();
}


bool identity::holds(const vec& row, const vec& roundings)
{
    double least = large;
    double most = -large;
    const unsigned n = count(columns_) - 1;
    for (unsigned corner = 0; corner < 1u << n; ++corner)
    {
        vec moved = row;
        for (unsigned i = 0; i < n; ++i)
        {
            moved[i + 1] += (corner >> i & 1 ? 1 : -1)*roundings[i + 1];
        }
        const double v = value(moved);
        if (!std::isfinite(v))
        {
            return false;
        }
        least = std::min(least, v);
        most = std::max(most, v);
    }
    return row[0] + roundings[0] >= least && row[0] - roundings[0] <= most;
}

} // End namespace statistics
