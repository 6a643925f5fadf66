// SPDX-License-Identifier: GPL-3.0-or-later
// The material points of a rank: a list for each of their properties.

#include "pointSet.H"

#include <cstring>

namespace
{
    template<class Column>
    using elementOf = typename std::decay_t<Column>::value_type;
}


void Foam::pointSet::resize(const label n)
{
    const label before = size();

    each([=](auto& column)
    {
        column.setSize(n);
        for (label i = before; i < n; ++i)
        {
            column[i] = elementOf<decltype(column)>(Zero);
        }
    });
}


void Foam::pointSet::take(const labelUList& order)
{
    each([&](auto& column)
    {
        std::decay_t<decltype(column)> taken(order.size());
        taken.setSize(order.size());

        forAll(order, i)
        {
            taken[i] = column[order[i]];
        }
        column.swap(taken);
    });
}


Foam::label Foam::pointSet::nBytes()
{
    label n = 0;
    pointSet none;

    none.each([&](auto& column)
    {
        n += sizeof(elementOf<decltype(column)>);
    });

    return n;
}


void Foam::pointSet::pack(const label i, DynamicList<char>& buffer)
{
    label at = buffer.size();
    buffer.setSize(at + nBytes());

    each([&](auto& column)
    {
        std::memcpy(&buffer[at], &column[i], sizeof(column[i]));
        at += sizeof(column[i]);
    });
}


void Foam::pointSet::unpack(const UList<char>& buffer)
{
    const label before = size();
    const label n = buffer.size()/nBytes();
    label at = 0;

    resize(before + n);

    for (label i = before; i < before + n; ++i)
    {
        each([&](auto& column)
        {
            void* to = &column[i];
            std::memcpy(to, &buffer[at], sizeof(column[i]));
            at += sizeof(column[i]);
        });
    }
}
