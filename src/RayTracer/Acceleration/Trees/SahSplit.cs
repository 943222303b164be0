using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Acceleration;

/// <summary>
/// Where to cut primitives in two: their middles are sorted into bins along each axis, and the border between bins with the least expected
/// cost is taken (Wald 2007). Costs count leaves, not primitives, since a leaf is tested at once.
/// </summary>
internal struct SahSplit
{
    /// <summary>Most bins an axis.</summary>
    public const int MaxBins = 32;

    /// <summary>The axis; −1 where all middles fall together.</summary>
    public int Axis;

    /// <summary>The first bin of the upper side.</summary>
    public int Position;

    /// <summary>Number of bins.</summary>
    public int Bins;

    private Vector128<float> _offset;
    private Vector128<float> _scale;

    /// <summary>Lays bins over a range; no axis is chosen yet.</summary>
    public static SahSplit Over(in BvhRange range)
    {
        int bins = range.Count <= 64 ? 8 + (range.Count >> 3) : Math.Min(MaxBins, 4 + (range.Count >> 4));
        Vector128<float> extent = range.Middles.Upper - range.Middles.Lower;
        Vector128<float> wide = Vector128.GreaterThan(extent, Vector128.Create(1e-35f));
        return new()
        {
            Axis = -1,
            Bins = bins,
            _offset = range.Middles.Lower,
            _scale = Vector128.ConditionalSelect(wide, Vector128.Create(bins * 0.99999f) / extent, Vector128<float>.Zero),
        };
    }

    /// <summary>The bins of a primitive, an axis a lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly Vector128<int> BinsOf(Vector128<float> middle)
    {
        Vector128<float> place = (middle - _offset) * _scale;
        return Sse2.IsSupported ? Sse2.ConvertToVector128Int32WithTruncation(place) : Vector128.ConvertToInt32(place);
    }

    /// <summary>Returns whether a primitive belongs to the lower side.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly bool IsLower(Vector128<float> middle) =>
        (Vector128.LessThan(BinsOf(middle), Vector128.Create(Position)).ExtractMostSignificantBits() >> Axis & 1) != 0;

    /// <summary>Chooses axis and position.</summary>
    /// <param name="bins">Bins filled with the range's primitives.</param>
    /// <param name="leafSize">Primitives that a leaf holds.</param>
    public unsafe void Choose(SahBins bins, int leafSize)
    {
        float* upperArea = stackalloc float[MaxBins];
        int* upperCount = stackalloc int[MaxBins];
        float best = float.PositiveInfinity;
        for (int axis = 0; axis < 3; axis++)
        {
            Box4* boxes = bins.Boxes(axis);
            int* counts = bins.Counts(axis);
            Box4 side = Box4.Empty;
            int count = 0;
            for (int bin = Bins - 1; bin > 0; bin--)
            {
                side.Grow(boxes[bin]);
                count += counts[bin];
                upperArea[bin] = side.HalfArea;
                upperCount[bin] = count;
            }

            side = Box4.Empty;
            count = 0;
            for (int bin = 1; bin < Bins; bin++)
            {
                side.Grow(boxes[bin - 1]);
                count += counts[bin - 1];
                if (count == 0 || upperCount[bin] == 0)
                {
                    continue;
                }

                float cost = (side.HalfArea * Leaves(count, leafSize)) + (upperArea[bin] * Leaves(upperCount[bin], leafSize));
                if (cost < best)
                {
                    best = cost;
                    Axis = axis;
                    Position = bin;
                }
            }
        }
    }

    private static int Leaves(int count, int leafSize) => (int)((uint)(count + leafSize - 1) / (uint)leafSize);
}
