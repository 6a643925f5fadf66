// SPDX-License-Identifier: GPL-3.0-or-later
// One entry of a case that a run has otherwise than the template.

#include "caseChange.H"
#include "keywords.H"
#include "textFile.H"

#include "functionBlocks.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"

#include <cstdio>
#include <sstream>

namespace
{

//- The tokens of an entry as they stand in the file
Foam::string readValue(const Foam::dictionary& dict)
{
    if (!dict.found("value"))
    {
        return "";
    }
    Foam::OStringStream os;
    os.precision(12);
    const Foam::ITstream& is = dict.lookup("value");
    forAll(is, i)
    {
        os << (i ? " " : "") << is[i];
    }
    return os.str();
}


//- While it lives, #include, #calc and $variables are kept as they stand
class asTheyStand
{
    const int old_ = Foam::entry::disableFunctionEntries;

public:

    asTheyStand()
    {
        Foam::entry::disableFunctionEntries = 1;
    }

    ~asTheyStand()
    {
        Foam::entry::disableFunctionEntries = old_;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::caseChange::applyToDictionary
(
    const fileName& path,
    const string& value
) const
{
    const asTheyStand keep;
    functionBlocks blocks(contentOf(path));
    IStringStream is(blocks.text(), IOstream::ASCII);
    is.name() = path;
    dictionary content;
    content.name() = path;
    content.read(is, true);

    const fileName scope(fileName(name_).path());
    const word last(fileName(name_).name(), false);
    dictionary* dict =
        add_ ? content.makeScopedDict(scope) : content.findScopedDict(scope);
    if (!dict)
    {
        FatalErrorInFunction
            << path << " has no dictionary " << scope.c_str() << " to change "
            << name_.c_str() << " in. If it shall be new: add true;" << exit(FatalError);
    }
    if (!add_ && !dict->found(last, keyType::LITERAL))
    {
        FatalErrorInFunction
            << path << " has no entry " << name_.c_str()
            << " to change. If it shall be new: add true;  Entries there: "
            << keywords::listed(dict->toc()).c_str() << exit(FatalError);
    }
    IStringStream text(last + ' ' + blocks.add(value) + ';');
    const autoPtr<entry> e(entry::New(text));
    dict->set(e->clone(*dict).ptr());

    // A copy may share the file by a link: it is replaced, never written into
    OStringStream os;
    os.precision(12);
    content.write(os, false);
    writeWhole(path, blocks.restored(os.str()));
}


void Foam::misfit::caseChange::applyToScript
(
    const fileName& path,
    const string& value
) const
{
    std::string text;
    label matches = 0;
    {
        IFstream is(path);
        std::string s;
        while (std::getline(is.stdStream(), s))
        {
            std::istringstream words(s);
            std::string command, name, style;
            words >> command >> name >> style;
            if (command == "variable" && name == name_ && style == "equal")
            {
                s = "variable " + name_ + " equal " + value;
                ++matches;
            }
            text += s + '\n';
        }
    }
    if (matches != 1)
    {
        FatalErrorInFunction
            << path << " has " << matches << " lines \"variable "
            << name_.c_str() << " equal ...\"; one is needed to change it"
            << exit(FatalError);
    }
    writeWhole(path, text);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::caseChange::caseChange(const dictionary& dict)
:
    file_(dict.get<fileName>("file")),
    isVariable_(dict.found("variable")),
    add_(dict.getOrDefault<bool>("add", false)),
    value_(readValue(dict)),
    scale_(dict.getOrDefault<scalar>("scale", 1)),
    offset_(dict.getOrDefault<scalar>("offset", 0))
{
    keywords::check
    (
        dict,
        {"file", "entry", "variable", "add", "value", "scale", "offset"}
    );
    if (isVariable_ == dict.found("entry"))
    {
        FatalIOErrorInFunction(dict)
            << "A change of " << file_ << " needs either entry (of a"
            << " dictionary) or variable (of a LIGGGHTS script)"
            << exit(FatalIOError);
    }
    const token name(dict.lookup(isVariable_ ? "variable" : "entry"));
    name_ = name.isString() ? name.stringToken() : string(name.wordToken());
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::string Foam::misfit::caseChange::value(const scalar number) const
{
    if (isFixed())
    {
        return value_;
    }
    char text[32];
    std::snprintf(text, sizeof(text), "%.10g", scale_*number + offset_);
    return text;
}


Foam::string Foam::misfit::caseChange::describe(const scalar number) const
{
    return file_ + ' ' + name_ + " = " + value(number);
}


void Foam::misfit::caseChange::apply
(
    const fileName& caseFolder,
    const scalar number
) const
{
    const fileName path(caseFolder/file_);
    if (newFile_ && !isFile(path, false))
    {
        writeWhole
        (
            path,
            "FoamFile { version 2.0; format ascii; class dictionary; object "
          + path.name() + "; }\n"
        );
    }
    if (!isFile(path, false))
    {
        const string hint
        (
            file_.find("0.orig/") == 0
          ? string(". A run has its 0.orig as 0: write 0/" + file_.name()) : string()
        );
        FatalErrorInFunction
            << "The case has no file " << file_ << " to change "
            << name_.c_str() << " in" << hint.c_str()
            << (hint.empty() ? ". Correct file, or add it to the case" : "")
            << exit(FatalError);
    }
    if (isVariable_)
    {
        applyToScript(path, value(number));
    }
    else
    {
        applyToDictionary(path, value(number));
    }
}


Foam::List<Foam::misfit::caseChange> Foam::misfit::readChanges
(
    const dictionary& dict,
    const word& key
)
{
    List<caseChange> changes;
    if (dict.found(key))
    {
        for (const dictionary& d : dict.get<List<dictionary>>(key))
        {
            changes.append(caseChange(d));
        }
    }
    return changes;
}
