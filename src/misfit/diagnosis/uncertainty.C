// SPDX-License-Identifier: GPL-3.0-or-later
// S0: how far simulation and recording may differ with nothing wrong.

#include "diagnosis.H"

Foam::List<Foam::misfit::runState> Foam::misfit::diagnosis::bases() const
{
    List<runState> states;
    for (const observed& o : sampler_.data())
    {
        states.append(state(bounds_.mean));
        states.last().experiment = o.experiment;
    }
    return states;
}


void Foam::misfit::diagnosis::checkBases()
{
    const List<samples> given(sampler_(bases()));
    if (!given.first().ok())
    {
        FatalErrorInFunction
            << "The base case did not run: " << given.first().failure.c_str()
            << nl << "Mend the case first; nothing was diagnosed. If the case"
            << " is sound, delete its folder in misfit/runs to have it run again"
            << exit(FatalError);
    }
    for (label i = 1; i < given.size(); ++i)
    {
        if (!given[i].ok())
        {
            WarningInFunction
                << "The base of the experiment "
                << sampler_.data()[i].experiment << " did not run: "
                << given[i].failure.c_str() << nl
                << "It will confirm nothing until that is mended" << endl;
        }
    }
}


void Foam::misfit::diagnosis::leaveOut(const runState& s, const string& why)
{
    found_.failedRuns.append(told(s) + ": " + why);
    Info<< "    left out: " << found_.failedRuns.last().c_str() << endl;
}


Foam::List<Foam::misfit::runState>
Foam::misfit::diagnosis::uncertaintyRuns(const word& experiment) const
{
    List<runState> states;
    for (label packing = 0; packing < settings_.packings; ++packing)
    {
        states.append(state(bounds_.mean, packing));
    }
    for (const word& name : settings_.resolutions)
    {
        states.append(state(bounds_.mean));
        states.last().resolution = name;
    }
    for (runState& s : states)
    {
        s.experiment = experiment;
    }
    return states;
}


void Foam::misfit::diagnosis::uncertainty()
{
    Info<< "S0 uncertainty" << endl;
    const List<runState> states(uncertaintyRuns(data().experiment));
    checkBases();
    const List<samples> given(ask(states));

    mat fit(fit_->size(), 0);
    mat gate(gate_->size(), 0);
    forAll(given, i)
    {
        if (!given[i].ok() && i >= settings_.packings)
        {
            const word& name = states[i].resolution;
            FatalErrorInFunction
                << "The run with other " << name << " failed: "
                << given[i].failure.c_str() << nl << "Without it what numerics"
                << " change would be taken for physics. Mend resolution/" << name
                << " in system/misfitDict, or take it out. Finished runs are"
                << " kept" << exit(FatalError);
        }
        else if (!given[i].ok() && i < settings_.common)
        {
            FatalErrorInFunction
                << "Packing " << i << ", one of the common " << settings_.common
                << " that every state is computed with, failed: "
                << given[i].failure.c_str() << nl << "Mend what 'packing' changes"
                << " in system/misfitDict, or ask for fewer with 'common'."
                << " Finished runs are kept" << exit(FatalError);
        }
        else if (!given[i].ok())
        {
            leaveOut(states[i], given[i].failure);
        }
        else if (i < settings_.packings)
        {
            appendColumn(fit, given[i].fit);
            appendColumn(gate, given[i].gate);
        }
        else
        {
            const vec ofFit = given[i].fit - given.first().fit;
            const vec ofGate = given[i].gate - given.first().gate;
            checkChanges(states[i].resolution, ofFit, ofGate);
            fit_->addDifference(states[i].resolution, ofFit);
            gate_->addDifference(states[i].resolution, ofGate);
        }
    }
    if (settings_.packings > 1 && fit.cols() < 2)
    {
        FatalErrorInFunction
            << "Of " << settings_.packings << " packings only " << label(fit.cols())
            << " ran, so nothing is known of the spread between them: mend what"
            << " 'packing' changes in system/misfitDict. Finished runs are kept"
            << exit(FatalError);
    }
    checkPackings(fit, gate);
    fit_->addRepeats(fit, settings_.common);
    gate_->addRepeats(gate, settings_.common);
}


void Foam::misfit::diagnosis::checkChanges
(
    const word& resolution,
    const vec& fit,
    const vec& gate
) const
{
    if (fit.isZero(0) && gate.isZero(0))
    {
        FatalErrorInFunction
            << "The run with other " << resolution << " gives the same numbers in"
            << " all channels, so what numerics change would be taken for physics."
            << nl << "    Does resolution/" << resolution << " in system/misfitDict"
            << " set the case's own values? Finished runs are kept"
            << exit(FatalError);
    }
}


void Foam::misfit::diagnosis::checkPackings
(
    const mat& fit,
    const mat& gate
) const
{
    for (label i = 0; i < fit.cols(); ++i)
    {
        for (label j = 0; j < i; ++j)
        {
            if (fit.col(i) == fit.col(j) && gate.col(i) == gate.col(j))
            {
                FatalErrorInFunction
                    << "Two packings give the same numbers in all channels, so"
                    << " the spread between packings comes out too small."
                    << nl << "    Does what 'packing' changes in"
                    << " system/misfitDict take the case's own value once more?"
                    << " 'offset 1;' in it makes the second packing 2."
                    << exit(FatalError);
            }
        }
    }
}
