using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Finds numbers in ascending tables from 0 to 1: the range is cut into as many parts as there are entries, and it is known where each part begins (Chen &amp;
/// Asau 1974).
/// </summary>
internal static unsafe class GuideTable
{
    /// <summary>Finds the parts.</summary>
    /// <param name="table">One more than <paramref name="count"/> numbers, the first 0.</param>
    /// <param name="count">The number of parts.</param>
    /// <param name="guides">Takes as many entries as the table has: those below each part end there.</param>
    public static void Fill(float* table, int count, uint* guides)
    {
        uint entry = 0;
        for (int part = 0; part <= count; part++)
        {
            // Rounded as lanes round: an entry of an earlier part than a number's is below the number.
            while (entry < count && (int)(table[entry + 1] * count) < part)
            {
                entry++;
            }

            guides[part] = entry;
        }
    }

    /// <summary>Finds the last entries that are not above numbers.</summary>
    /// <param name="table">Tables, one behind the other.</param>
    /// <param name="guides">Their guides.</param>
    /// <param name="first">Where the tables of the lanes begin.</param>
    /// <param name="count">The number of parts of each.</param>
    /// <param name="u">The numbers.</param>
    public static UIntW Find(float* table, uint* guides, UIntW first, int count, in FloatW u)
    {
        UIntW part = FloatW.Max(0f, FloatW.Min(u * count, count - 1f)).ToIntInRange();
        UIntW.Gather(guides, first + part, out UIntW found, out UIntW last);
        for (UIntW entries = last - found + 1u; (entries > 1u).Any;)
        {
            UIntW half = entries >> 1;
            MaskW isBelow = FloatW.Gather(table, first + found + half) <= u;
            found = isBelow.Select(found + half, found);
            entries = isBelow.Select(entries - half, half);
        }

        return found;
    }
}
