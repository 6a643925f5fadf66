// SPDX-License-Identifier: GPL-3.0-or-later
// Makes cases whose cause is concealed, and the key to them.

#include "concealedSet.H"
#include "report.H"

#include "OSspecific.H"
#include "keywords.H"

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using json = nlohmann::ordered_json;

//- What is the matter with a case
struct concealed
{
    string kind;

    wordList mechanisms;

    scalarList strengths;

    word faulty;

    word fault;

    scalar faultSize = 0;

    //- Noise over what the channels state
    scalar level = 1;

    runState state;

    //- Common shift of time [s]
    scalar jitter = 0;
};


class maker
{
    std::mt19937 generator_;

    std::uniform_real_distribution<scalar> any_;

    std::normal_distribution<scalar> normal_;

    List<parameter> parameters_;

    wordList library_;

    wordList outside_;


public:

    maker(const dictionary& dict, const label seed)
    :
        generator_(seed),
        parameters_(readParameters(dict.subDict("parameters")))
    {
        for (const word& name : dict.subDict("candidates").toc())
        {
            const bool known = name != "block" && name != "jet";
            (known ? library_ : outside_).append(name);
        }
    }

    scalar uniform(const scalar from, const scalar to)
    {
        return from + (to - from)*any_(generator_);
    }

    scalar normal()
    {
        return normal_(generator_);
    }

    label pick(const label n)
    {
        return min(label(n*any_(generator_)), n - 1);
    }

    void add(concealed& c, const word& name)
    {
        c.mechanisms.append(name);
        c.strengths.append(uniform(0.25, 1));
        c.state.strengths.insert(name, c.strengths.last());
    }

    void addFault(concealed& c)
    {
        c.faulty = wordList({"P1", "E1", "L1", "L2"})[pick(4)];
        c.fault = wordList({"gain", "zero", "lag", "drift", "clock"})[pick(5)];
        const scalar side = pick(2) ? 1 : -1;
        c.faultSize =
            c.fault == "gain" ? side*uniform(0.1, 0.3)
          : c.fault == "lag" ? uniform(0.03, 0.12)
          : c.fault == "clock" ? side*uniform(0.03, 0.1)
          : side*uniform(0.05, 0.2);
    }

    //- In the shares 30 % nulls, 25 % singles, 12 % pairs, 15 % outside the
    //  library, 18 % faults
    concealed draw()
    {
        concealed c;
        const scalar lot = any_(generator_);
        for (const parameter& p : parameters_)
        {
            const scalar x = p.mean + p.deviation*normal();
            c.state.parameters.insert(p.name, min(max(x, p.lower), p.upper));
        }
        c.jitter = 0.005*normal();
        c.level = pick(2) ? 2 : 1;
        if (lot < 0.3)
        {
            c.kind = "null";
        }
        else if (lot < 0.55)
        {
            c.kind = "single";
            add(c, library_[pick(library_.size())]);
        }
        else if (lot < 0.67)
        {
            c.kind = "pair";
            const label i = pick(library_.size());
            const label j = (i + 1 + pick(library_.size() - 1)) % library_.size();
            add(c, library_[i]);
            add(c, library_[j]);
        }
        else if (lot < 0.82)
        {
            c.kind = "outside";
            add(c, outside_[pick(outside_.size())]);
        }
        else
        {
            c.kind = "sensor";
            addFault(c);
        }
        return c;
    }
};


scalar range(const series& s)
{
    scalar low = GREAT;
    scalar high = -GREAT;
    for (const scalar y : s.y)
    {
        low = min(low, y);
        high = max(high, y);
    }
    return high - low;
}


//- What a channel would record at 5 ms steps, faulty and without noise
series recorded(const series& truth, const concealed& c, const word& channel)
{
    series s;
    const bool bad = channel == c.faulty;
    const scalar end = truth.x.last();
    const scalar size = range(truth);
    scalar shown = truth(0);
    for (scalar t = 0.01; t < end - 0.02; t += 0.005)
    {
        const scalar late =
            c.jitter + (bad && c.fault == "clock" ? c.faultSize : 0);
        scalar y = truth(max(t - late, 0.0));
        if (bad && c.fault == "gain")
        {
            y *= 1 + c.faultSize;
        }
        else if (bad && c.fault == "zero")
        {
            y += c.faultSize*size;
        }
        else if (bad && c.fault == "drift")
        {
            y += c.faultSize*size*t/end;
        }
        else if (bad && c.fault == "lag")
        {
            shown += (y - shown)*(1 - std::exp(-0.005/c.faultSize));
            y = shown;
        }
        s.x.append(t);
        s.y.append(y);
    }
    return s;
}


//- White noise and a part that remembers 20 ms, with the stated deviation
void addNoise(series& s, const scalar deviation, maker& m)
{
    scalar slow = m.normal();
    const scalar keep = std::exp(-0.005/0.02);
    for (scalar& y : s.y)
    {
        slow = keep*slow + Foam::sqrt(1 - keep*keep)*m.normal();
        y += deviation*(Foam::sqrt(0.8)*m.normal() + Foam::sqrt(0.2)*slow);
    }
}


void writeCsv(const fileName& file, const series& s, const word& quantity)
{
    std::ofstream os(file);
    os << "t_s," << (quantity == "pressure" ? "p_Pa" : "h_m") << '\n';
    forAll(s.x, i)
    {
        os << s.x[i] << ',' << s.y[i] << '\n';
    }
}


//- Effect of what is concealed at the channels of experiment A: where it is
//  above two deviations of the noise and a quarter of its largest, and the largest norm over the noise of a channel
json effect
(
    const recordings& all,
    const concealed& c,
    const prediction& with,
    const prediction& without
)
{
    json places = json::array();
    scalar most = 0;
    scalar largest = 0;
    List<series> over(all.channels().size());
    forAll(all.channels(), i)
    {
        const channel& ch = all.channels()[i];
        if (ch.experiment() != "A")
        {
            continue;
        }
        concealed sound(c);
        sound.faulty = "";
        const series a(recorded(with.channels[i], c, ch.name()));
        const series b(recorded(without.channels[i], sound, ch.name()));
        scalar sum = 0;
        forAll(a.x, k)
        {
            const scalar d =
                mag(a.y[k] - b.y[k])/(c.level*ch.uncertainty());
            sum += sqr(d);
            over[i].x.append(a.x[k]);
            over[i].y.append(d);
            largest = max(largest, d);
        }
        most = max(most, Foam::sqrt(sum));
    }

    forAll(over, i)
    {
        scalar from = GREAT;
        scalar to = -GREAT;
        forAll(over[i].x, k)
        {
            if (over[i].y[k] > max(2.0, 0.25*largest))
            {
                from = min(from, over[i].x[k]);
                to = max(to, over[i].x[k]);
            }
        }
        if (to > from)
        {
            places.push_back
            ({
                {"channel", all.channels()[i].name()},
                {"from", from},
                {"to", to}
            });
        }
    }
    return {{"snr", most}, {"places", places}};
}


json keyOf(const concealed& c, const word& name)
{
    json k = {{"case", name}, {"kind", c.kind}, {"noise", c.level}};
    k["mechanisms"] = json::array();
    forAll(c.mechanisms, i)
    {
        k["mechanisms"].push_back
        ({
            {"name", c.mechanisms[i]}, {"strength", c.strengths[i]}
        });
    }
    k["faulty"] = c.faulty;
    k["fault"] = c.fault;
    k["faultSize"] = c.faultSize;
    return k;
}

} // End anonymous namespace


void Foam::misfit::makeCases
(
    concealedSide& truth,
    const fileName& folder,
    const fileName& keyFile,
    const label n,
    const label seed
)
{
    maker m(truth.dict(), seed);
    List<concealed> all(n);
    List<runState> states;
    for (concealed& c : all)
    {
        c = m.draw();
        for (const word& e : truth.bare().experiments())
        {
            runState s(c.state);
            s.experiment = e;
            s.packing = 1;
            states.append(s);
        }
        runState without(c.state);
        without.strengths.clear();
        without.packing = 1;
        states.append(without);
    }
    const List<prediction> given(truth.predict().predict(states));

    json key = json::array();
    const label each = truth.bare().experiments().size() + 1;
    forAll(all, i)
    {
        std::string number(std::to_string(i + 1));
        number.insert(0, 4 - min(label(number.size()), 4), '0');
        const fileName target(folder/number);
        mkDir(target);
        writeWhole(target/"level", shortNumber(all[i].level) + '\n');

        forAll(truth.bare().channels(), k)
        {
            const channel& ch = truth.bare().channels()[k];
            for (label e = 0; e < each - 1; ++e)
            {
                const prediction& p = given[i*each + e];
                if (states[i*each + e].experiment == ch.experiment() && p.ok())
                {
                    series s(recorded(p.channels[k], all[i], ch.name()));
                    addNoise(s, all[i].level*ch.uncertainty(), m);
                    writeCsv(target/ch.name() + ".csv", s, ch.quantity());
                }
            }
        }
        json k(keyOf(all[i], number));
        k["effect"] = effect
        (
            truth.bare(), all[i], given[i*each], given[i*each + each - 1]
        );
        key.push_back(k);
    }
    writeWhole(keyFile, key.dump(1) + '\n');
}
