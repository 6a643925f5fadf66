// SPDX-License-Identifier: GPL-3.0-or-later
// Whether verdicts are right as often as their confidences say.

#include "reliability.H"

#include <sstream>

void Foam::misfit::reliability::add(const scalar confidence, const bool right)
{
    const size_t last = tenths_.size() - 1;
    tenth& t = tenths_[min(size_t(confidence*tenths_.size()), last)];
    ++t.n;
    t.right += right;
    t.confidence += confidence;
    squares_.append(sqr(confidence - right));
}


std::string Foam::misfit::reliability::rows() const
{
    std::ostringstream os;
    os << "from,to,cases,confidence,right,low,high\n";
    const scalar width = 1.0/tenths_.size();
    for (size_t i = 0; i < tenths_.size(); ++i)
    {
        const tenth& t = tenths_[i];
        const interval share(ofShare(t.right, t.n));
        os << i*width << ',' << (i + 1)*width << ',' << t.n << ',';
        if (t.n)
        {
            os << t.confidence/t.n << ',' << share.value << ',' << share.low << ','
                << share.high << '\n';
        }
        else
        {
            os << ",,,\n";
        }
    }
    return os.str();
}
