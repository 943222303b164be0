using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>Bins along the three axes: how many primitives fall into each, and what holds them.</summary>
internal sealed unsafe class SahBins : IDisposable
{
    private const int Slots = 3 * SahSplit.MaxBins;
    private readonly NativeMemoryBlock _memory = new(Slots * (sizeof(Box4) + sizeof(int)));

    /// <summary>Boxes of the bins of an axis.</summary>
    public Box4* Boxes(int axis) => (Box4*)_memory.Pointer + (axis * SahSplit.MaxBins);

    /// <summary>Numbers of primitives in the bins of an axis.</summary>
    public int* Counts(int axis) => (int*)(_memory.Pointer + (Slots * sizeof(Box4))) + (axis * SahSplit.MaxBins);

    /// <summary>Sorts primitives into bins that were empty.</summary>
    public void Fill(PrimitiveReference* first, int count, in SahSplit split)
    {
        Clear(split.Bins);
        Box4* boxesX = Boxes(0);
        Box4* boxesY = Boxes(1);
        Box4* boxesZ = Boxes(2);
        int* countsX = Counts(0);
        int* countsY = Counts(1);
        int* countsZ = Counts(2);
        SahSplit bins = split;
        PrimitiveReference* end = first + count;
        for (PrimitiveReference* primitive = first; primitive < end; primitive++)
        {
            Vector128<float> lower = primitive->Lower;
            Vector128<float> upper = primitive->Upper;
            Vector128<int> bin = bins.BinsOf(lower + upper);
            int x = bin[0];
            int y = bin[1];
            int z = bin[2];
            countsX[x]++;
            countsY[y]++;
            countsZ[z]++;
            boxesX[x].Grow(lower, upper);
            boxesY[y].Grow(lower, upper);
            boxesZ[z].Grow(lower, upper);
        }
    }

    /// <summary>Adds the contents of other bins of the same split.</summary>
    public void Add(SahBins other, int bins)
    {
        for (int axis = 0; axis < 3; axis++)
        {
            for (int bin = 0; bin < bins; bin++)
            {
                Boxes(axis)[bin].Grow(other.Boxes(axis)[bin]);
                Counts(axis)[bin] += other.Counts(axis)[bin];
            }
        }
    }

    /// <summary>Number of primitives below a border.</summary>
    public int CountBelow(int axis, int position)
    {
        int count = 0;
        for (int bin = 0; bin < position; bin++)
        {
            count += Counts(axis)[bin];
        }

        return count;
    }

    public void Dispose() => _memory.Dispose();

    private void Clear(int bins)
    {
        for (int axis = 0; axis < 3; axis++)
        {
            new Span<Box4>(Boxes(axis), bins).Fill(Box4.Empty);
            new Span<int>(Counts(axis), bins).Clear();
        }
    }
}
