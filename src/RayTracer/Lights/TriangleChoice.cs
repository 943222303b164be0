namespace RayTracer.Lights;

/// <summary>Chooses one of some triangles with a probability in proportion to its area.</summary>
internal sealed class TriangleChoice
{
    private readonly int[] _triangles;

    // Probability of all triangles up to each one: rounded once, so that differences are the probabilities with which they are chosen.
    private readonly float[] _upTo;

    /// <summary>Makes the table.</summary>
    /// <param name="triangles">The triangles, in the order of their numbers.</param>
    /// <param name="area">The area of each.</param>
    public TriangleChoice(int[] triangles, Func<int, double> area)
    {
        _triangles = triangles;
        double[] sums = new double[triangles.Length];
        double sum = 0;
        for (int i = 0; i < sums.Length; i++)
        {
            sum += area(triangles[i]);
            sums[i] = sum;
        }

        _upTo = [.. sums.Select(s => (float)(s / sum))];
        Area = (float)sum;
        IsFinite = sum > 0 && double.IsFinite(sum);
    }

    /// <summary>The triangles.</summary>
    public IReadOnlyList<int> Triangles => _triangles;

    /// <summary>The area of all.</summary>
    public float Area { get; }

    /// <summary>There is an area, and not too large a one.</summary>
    public bool IsFinite { get; }

    /// <summary>The probability with which a triangle is chosen.</summary>
    public float Probability(int triangle)
    {
        int i = Array.BinarySearch(_triangles, triangle);
        return i < 0 ? 0 : _upTo[i] - (i == 0 ? 0 : _upTo[i - 1]);
    }

    /// <summary>Chooses.</summary>
    /// <param name="u">A number from 0 up to 1. Out: one that is as random again, within what was chosen.</param>
    /// <param name="probability">The probability of the choice.</param>
    /// <returns>The triangle.</returns>
    public int Choose(ref float u, out float probability)
    {
        // The first entry above u.
        int low = 0;
        int high = _upTo.Length - 1;
        while (low < high)
        {
            int middle = (low + high) / 2;
            (low, high) = _upTo[middle] > u ? (low, middle) : (middle + 1, high);
        }

        float before = low == 0 ? 0 : _upTo[low - 1];
        probability = _upTo[low] - before;
        u = float.Min((u - before) / probability, float.BitDecrement(1));
        return _triangles[low];
    }
}
