// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, fitted and weighed in one way: the samples
// under a hypothesis.

#include "hypothesis.H"

#include <algorithm>

bool Foam::misfit::hypothesis::contains(const hypothesis& other) const
{
    for (const label m : other.mechanisms)
    {
        if (!mechanisms.found(m))
        {
            return false;
        }
    }
    return true;
}


bool Foam::misfit::hypothesis::extends(const hypothesis& other) const
{
    return
        contains(other)
     && (!other.fault || other.fault == fault)
     && (unknown || !other.unknown)
     && size() > other.size();
}


Foam::misfit::hypothesisModel::hypothesisModel
(
    const responseSurface& surface,
    const variableBounds& bounds,
    const hypothesis& h
)
:
    surface_(surface),
    bounds_(bounds),
    hypothesis_(h)
{}


Foam::misfit::vec Foam::misfit::hypothesisModel::pick
(
    const vec& all,
    const vec& ofFault
) const
{
    const label nP = bounds_.nParameters;
    const label nM = hypothesis_.mechanisms.size();
    vec x(nP + nM + ofFault.size());
    x.head(nP) = all.head(nP);
    for (label i = 0; i < nM; ++i)
    {
        x[nP + i] = all[nP + hypothesis_.mechanisms[i]];
    }
    x.tail(ofFault.size()) = ofFault;
    return x;
}


Foam::misfit::vec
Foam::misfit::hypothesisModel::expand(const vec& x) const
{
    const label nP = bounds_.nParameters;
    vec all = vec::Zero(surface_.nVariables());
    all.head(nP) = x.head(nP);
    forAll(hypothesis_.mechanisms, i)
    {
        all[nP + hypothesis_.mechanisms[i]] = x[nP + i];
    }
    return all;
}


Foam::misfit::vec
Foam::misfit::hypothesisModel::ofFault(const vec& x) const
{
    return x.tail(hypothesis_.fault ? hypothesis_.fault->size() : 0);
}


Foam::misfit::vec
Foam::misfit::hypothesisModel::operator()(const vec& x) const
{
    const vec f = surface_(expand(x));
    return hypothesis_.fault ? (*hypothesis_.fault)(f, ofFault(x)) : f;
}


Foam::misfit::mat
Foam::misfit::hypothesisModel::slopes(const vec& x) const
{
    const vec all = expand(x);
    const mat ofAll = surface_.slopes(all);
    const label nP = bounds_.nParameters;
    const label nM = hypothesis_.mechanisms.size();

    mat s(ofAll.rows(), x.size());
    s.leftCols(nP) = ofAll.leftCols(nP);
    for (label i = 0; i < nM; ++i)
    {
        s.col(nP + i) = ofAll.col(nP + hypothesis_.mechanisms[i]);
    }
    if (!hypothesis_.fault)
    {
        return s;
    }

    // A small step: what a fault shows is linear in what it should show, but for
    // a saturated one
    constexpr scalar part = 1e-4;
    const sensorFault& fault = *hypothesis_.fault;
    const vec f = surface_(all);
    const vec u = ofFault(x);
    const vec shown = fault(f, u);
    for (label i = 0; i < nP + nM; ++i)
    {
        s.col(i) = (fault(f + part*vec(s.col(i)), u) - shown)/part;
    }
    const vec range = fault.upper() - fault.lower();
    for (label i = 0; i < u.size(); ++i)
    {
        vec beside = u;
        const scalar step =
            (u[i] + 1e-5*range[i] > fault.upper()[i] ? -1e-5 : 1e-5)*range[i];
        beside[i] += step;
        s.col(nP + nM + i) = (fault(f, beside) - shown)/step;
    }
    return s;
}


Foam::misfit::vec Foam::misfit::hypothesisModel::lower() const
{
    return pick
    (
        bounds_.lower,
        hypothesis_.fault ? hypothesis_.fault->lower() : vec(0)
    );
}


Foam::misfit::vec Foam::misfit::hypothesisModel::upper() const
{
    return pick
    (
        bounds_.upper,
        hypothesis_.fault ? hypothesis_.fault->upper() : vec(0)
    );
}


Foam::misfit::vec Foam::misfit::hypothesisModel::mean() const
{
    return pick
    (
        bounds_.mean,
        vec::Zero(hypothesis_.fault ? hypothesis_.fault->size() : 0)
    );
}


Foam::misfit::vec Foam::misfit::hypothesisModel::deviation() const
{
    return pick
    (
        bounds_.deviation,
        vec::Zero(hypothesis_.fault ? hypothesis_.fault->size() : 0)
    );
}


Foam::List<Foam::misfit::vec>
Foam::misfit::hypothesisModel::starts() const
{
    const label nP = bounds_.nParameters;
    vec from = bounds_.mean;
    from.tail(from.size() - nP) = 0.3*bounds_.upper.tail(from.size() - nP);

    List<vec> all;
    if (hypothesis_.fault)
    {
        for (const vec& u : hypothesis_.fault->starts())
        {
            all.append(pick(from, u));
        }
    }
    else
    {
        all.append(pick(from, vec(0)));
    }
    return all;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::misfit::sortByScore(List<weighed>& list)
{
    std::stable_sort
    (
        list.begin(),
        list.end(),
        [](const weighed& a, const weighed& b) { return a.score < b.score; }
    );
}
