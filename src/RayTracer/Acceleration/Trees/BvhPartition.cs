using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// Cuts ranges of primitives in two. What comes out depends on the primitives and their order only, never on the number of threads.
/// </summary>
internal static unsafe class BvhPartition
{
    /// <summary>Cuts a range in place, by exchanging primitives.</summary>
    public static void InPlace(in BvhRange range, in SahSplit split, out BvhRange lower, out BvhRange upper)
    {
        SahSplit border = split;
        Box4 lowerBounds = Box4.Empty;
        Box4 lowerMiddles = Box4.Empty;
        Box4 upperBounds = Box4.Empty;
        Box4 upperMiddles = Box4.Empty;
        PrimitiveReference* left = range.First;
        PrimitiveReference* right = range.First + range.Count - 1;
        while (true)
        {
            for (; left <= right && border.IsLower(left->Middle); left++)
            {
                Vector128<float> middle = left->Middle;
                lowerBounds.Grow(left->Lower, left->Upper);
                lowerMiddles.Grow(middle, middle);
            }

            for (; left <= right && !border.IsLower(right->Middle); right--)
            {
                Vector128<float> middle = right->Middle;
                upperBounds.Grow(right->Lower, right->Upper);
                upperMiddles.Grow(middle, middle);
            }

            if (left >= right)
            {
                break;
            }

            (*left, *right) = (*right, *left);
        }

        int count = (int)(left - range.First);
        lower = Range(range.First, count, range.Start, lowerBounds, lowerMiddles);
        upper = Range(left, range.Count - count, range.Start + count, upperBounds, upperMiddles);
    }

    /// <summary>Cuts a range in the middle of its order: for primitives that no plane can tell apart.</summary>
    public static void Halve(in BvhRange range, out BvhRange lower, out BvhRange upper)
    {
        int count = range.Count / 2;
        lower = Enclose(range.First, count, range.Start);
        upper = Enclose(range.First + count, range.Count - count, range.Start + count);
    }

    /// <summary>The range of some primitives.</summary>
    public static BvhRange Enclose(PrimitiveReference* first, int count, int start)
    {
        Box4 bounds = Box4.Empty;
        Box4 middles = Box4.Empty;
        for (int i = 0; i < count; i++)
        {
            Vector128<float> middle = first[i].Middle;
            bounds.Grow(first[i].Lower, first[i].Upper);
            middles.Grow(middle, middle);
        }

        return Range(first, count, start, bounds, middles);
    }

    /// <summary>A range with known boxes.</summary>
    public static BvhRange Range(PrimitiveReference* first, int count, int start, in Box4 bounds, in Box4 middles) => new()
    {
        First = first,
        Count = count,
        Start = start,
        Bounds = bounds,
        Middles = middles,
        Area = bounds.HalfArea,
    };

    /// <summary>Moves the primitives of one piece of a range to their sides in another array, keeping their order.</summary>
    /// <param name="first">The piece's first primitive.</param>
    /// <param name="count">Its number of primitives.</param>
    /// <param name="split">The border.</param>
    /// <param name="lower">In: where its lower primitives go. Out: what was put there.</param>
    /// <param name="upper">In: where its upper primitives go. Out: what was put there.</param>
    public static void Scatter(PrimitiveReference* first, int count, in SahSplit split, ref BvhRange lower, ref BvhRange upper)
    {
        SahSplit border = split;
        BvhRange low = lower;
        BvhRange high = upper;
        low.Bounds = low.Middles = high.Bounds = high.Middles = Box4.Empty;
        for (int i = 0; i < count; i++)
        {
            if (border.IsLower(first[i].Middle))
            {
                low.First[low.Count++] = first[i];
                low.Grow(first[i]);
            }
            else
            {
                high.First[high.Count++] = first[i];
                high.Grow(first[i]);
            }
        }

        lower = low;
        upper = high;
    }
}
