// SPDX-License-Identifier: GPL-3.0-or-later
// The options -list... of the solver, from the tables that also select at run time.

#include "lawLists.H"

#include "constitutiveLaw.H"
#include "forceModels.H"
#include "granularPhase.H"
#include "shapeFactor.H"
#include "smoothingModel.H"
#include "voidFractionModel.H"

namespace
{
    using namespace Foam;

    struct family
    {
        word option;

        string what;

        //- Where a case names one of them
        string keyword;

        wordList names;
    };


    template<class Base>
    wordList namesOf()
    {
        return Base::dictionaryConstructorTablePtr_->sortedToc();
    }


    //- Of a force, which can be switched off
    template<class Law>
    wordList lawsOf()
    {
        DynamicList<word> names(namesOf<Law>());
        names.append("none");
        return wordList(names);
    }


    List<family> families()
    {
        const string forces("interphaseForces/");

        return
        {
            {
                "listForces", "forces between fluid and grains",
                "interphaseForces", forceModels::names()
            },
            {
                "listDragModels", "drag models",
                forces + "drag/model", lawsOf<dragModel>()
            },
            {
                "listDragShapes", "drag of grains that are not spheres",
                forces + "drag/shape/model", lawsOf<shapeFactor>()
            },
            {
                "listLiftModels", "lift models",
                forces + "lift/model", lawsOf<liftModel>()
            },
            {
                "listVirtualMassModels", "virtual mass models",
                forces + "virtualMass/model", lawsOf<virtualMassModel>()
            },
            {
                "listRotationalDragModels", "rotational drag models",
                forces + "rotationalDrag/model", lawsOf<rotationalDragModel>()
            },
            {
                "listVoidFractionModels", "void fraction models",
                "voidFraction/model", namesOf<voidFractionModel>()
            },
            {
                "listSmoothingModels", "smoothing models",
                "voidFraction/smoothing/model", namesOf<smoothingModel>()
            },
            {
                "listGranularPhases", "granular phases",
                "granularPhase", namesOf<granularPhase>()
            },
            {
                "listConstitutiveLaws", "constitutive laws of material points",
                "law of a body", namesOf<constitutiveLaw>()
            }
        };
    }
}


void Foam::lawLists::addOptions()
{
    for (const family& f : families())
    {
        const bool advanced = f.option != "listForces";
        argList::addBoolOption(f.option, "List " + f.what, advanced);
    }
}


bool Foam::lawLists::print(const argList& args)
{
    bool printed = false;

    for (const family& f : families())
    {
        if (args.found(f.option))
        {
            Info<< f.what.c_str() << ": " << f.keyword.c_str() << nl
                << f.names.size() << nl << '(' << nl;
            for (const word& name : f.names)
            {
                Info<< name << nl;
            }
            Info<< ')' << endl;
            printed = true;
        }
    }

    return printed;
}
