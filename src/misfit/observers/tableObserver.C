// SPDX-License-Identifier: GPL-3.0-or-later
// Observes a column of a table that a function object of the case writes.

#include "observer.H"
#include "addToRunTimeSelectionTable.H"
#include "keywords.H"
#include "writtenTable.H"

namespace Foam::misfit
{

//- postProcessing/<function>/<startTime>/<file>: time and the column. For a
//  channel over a distance: postProcessing/<function>/<time>/<file> of the time
//  nearest to that of the channel, the columns of distance and value.
class tableObserver
:
    public observer
{
    word function_;

    fileName file_;

    //- Names or, from 1, numbers of the columns
    string x_;

    string y_;

    scalar scale_;

    scalar offset_;


public:

    TypeName("table");

    explicit tableObserver(const channel& c);

    series read(const fileName& caseFolder) const override;
};

defineTypeNameAndDebug(tableObserver, 0);
addToRunTimeSelectionTable(observer, tableObserver, channel);

} // End namespace Foam::misfit


namespace
{

//- What an entry holds: a word, a string or a number
Foam::string text
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::string& byDefault
)
{
    if (!dict.found(key))
    {
        return byDefault;
    }
    const Foam::token t(dict.lookup(key));
    return
        t.isNumber() ? Foam::string(std::to_string(Foam::label(t.number())))
      : t.isString() ? t.stringToken() : Foam::string(t.wordToken());
}


//- Number of a column, from 0
Foam::label column
(
    const Foam::misfit::writtenTable& table,
    const Foam::string& name
)
{
    if (name.find_first_not_of("0123456789") != std::string::npos)
    {
        return table.find(name);
    }
    if (std::stoi(name) < 1)
    {
        FatalErrorInFunction
            << "Columns are counted from 1, the first; there is no column "
            << name.c_str() << Foam::exit(Foam::FatalError);
    }
    return std::stoi(name) - 1;
}

} // End anonymous namespace


Foam::misfit::tableObserver::tableObserver(const channel& c)
:
    observer(c),
    function_(c.simulated.get<word>("function")),
    file_(c.simulated.get<fileName>("file")),
    x_(text(c.simulated, "xColumn", "1")),
    y_(text(c.simulated, "column", "2")),
    scale_(c.simulated.getOrDefault<scalar>("scale", 1)),
    offset_(c.simulated.getOrDefault<scalar>("offset", 0))
{
    keywords::check
    (
        c.simulated,
        {"type", "function", "file", "xColumn", "column", "scale", "offset"}
    );
}


Foam::misfit::series
Foam::misfit::tableObserver::read(const fileName& caseFolder) const
{
    const writtenTable table
    (
        of().overTime()
      ? writtenTable(caseFolder, function_, file_)
      : writtenTable
        (
            nearestTimeFolder(caseFolder, function_, of().at)/file_
        )
    );

    const label x = column(table, x_);
    const label y = column(table, y_);
    if (of().isNumber())
    {
        const label last = table.rows().size() - 1;
        return {{0.0}, {scale_*table.value(last, y) + offset_}};
    }

    series s;
    forAll(table.rows(), i)
    {
        const scalar at = table.value(i, x);
        if (s.x.empty() || at > s.x.last())
        {
            s.x.append(at);
            s.y.append(scale_*table.value(i, y) + offset_);
        }
    }
    return s;
}
