// SPDX-License-Identifier: GPL-3.0-or-later
// Grains and water as tables, for pictures.

#include "sideView.H"

#include "ListOps.H"
#include "addToRunTimeSelectionTable.H"
#include "grainSnapshot.H"
#include "volFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(sideView, 0);
    addToRunTimeSelectionTable(functionObject, sideView, dictionary);
}
}


namespace
{
    //- All ranks' rows on the master
    Foam::List<Foam::scalarList> gathered
    (
        const Foam::DynamicList<Foam::scalarList>& rows
    )
    {
        using namespace Foam;

        List<List<scalarList>> all(Pstream::nProcs());
        all[Pstream::myProcNo()] = rows;
        Pstream::gatherList(all);

        DynamicList<scalarList> result;
        for (const List<scalarList>& some : all)
        {
            result.append(some);
        }

        return List<scalarList>(std::move(result));
    }
}


Foam::functionObjects::sideView::sideView
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName),
    nearest_(GREAT)
{
    read(dict);
}


bool Foam::functionObjects::sideView::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys(dict, {"nearest"});
    nearest_ = dict.getOrDefault<scalar>("nearest", GREAT);
    return true;
}


void Foam::functionObjects::sideView::writeTable
(
    const word& name,
    const string& comment,
    const wordList& columns,
    const DynamicList<scalarList>& rows
)
{
    const List<scalarList> table(gathered(rows));
    if (!writes())
    {
        return;
    }
    autoPtr<OFstream> file(presentFile(name));
    writeColumns(*file, comment, columns, false);
    for (const scalarList& row : table)
    {
        writeRow(*file, row);
    }
}


void Foam::functionObjects::sideView::writeGrains()
{
    const grainSnapshot& all = grains();
    const scalar side = box().min().y();
    DynamicList<scalarList> rows;

    forAll(all.position, i)
    {
        const point p(frame_.local(all.position[i]));

        if (p.y() - side <= nearest_)
        {
            rows.append
            (
                scalarList
                ({
                    p.x(), p.y(), p.z(), all.d[i], mag(all.U[i]),
                    scalar(all.type[i]), scalar(all.id[i])
                })
            );
        }
    }

    writeTable
    (
        "grains",
        "Grains: place and diameter in m, speed in m/s, type, number of the grain",
        {"x", "y", "z", "d", "speed", "type", "id"},
        rows
    );
}


void Foam::functionObjects::sideView::writeCells()
{
    const tmp<volScalarField> alpha(field<volScalarField>(alphaName_));
    const tmp<volVectorField> U(field<volVectorField>("U"));
    const pointField& centres = mesh_.cellCentres();
    DynamicList<scalarList> rows;

    forAll(centres, cell)
    {
        const point p(frame_.local(centres[cell]));

        rows.append
        (
            scalarList
            ({
                p.x(), p.y(), p.z(), cbrt(mesh_.V()[cell]), alpha()[cell],
                mag(U()[cell])
            })
        );
    }

    writeTable
    (
        "cells",
        "Cells: centre and size in m, share of water, speed in m/s",
        {"x", "y", "z", "size", "alpha", "speed"},
        rows
    );
}


void Foam::functionObjects::sideView::report()
{
    if (!passOver({alphaName_, "U"}))
    {
        writeGrains();
        if (fluid_)
        {
            writeCells();
        }
    }
}
