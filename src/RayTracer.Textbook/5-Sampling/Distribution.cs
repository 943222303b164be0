namespace RayTracer.Textbook;

/// <summary>Chooses one of some numbers, in proportion to their weights.</summary>
public sealed class Distribution
{
    // Sums of the weights of all numbers below.
    private readonly double[] _sums;

    /// <summary>From weights.</summary>
    /// <param name="weights">At least 0; where all are 0, all are chosen alike.</param>
    public Distribution(params double[] weights)
    {
        _sums = new double[weights.Length + 1];
        bool isEven = weights.Sum() == 0;
        for (int i = 0; i < weights.Length; i++)
        {
            _sums[i + 1] = _sums[i] + (isEven ? 1 : weights[i]);
        }
    }

    /// <summary>The sum of all weights.</summary>
    public double Sum => _sums[^1];

    /// <summary>The probability of a number.</summary>
    public double Probability(int i) => (_sums[i + 1] - _sums[i]) / Sum;

    /// <summary>Chooses a number, and returns where within its share the random number lay: it is uniform again.</summary>
    public (int Chosen, double Left) Choose(double random)
    {
        double at = random * Sum;
        int low = 0;
        int high = _sums.Length - 1;
        while (high - low > 1)
        {
            int middle = (low + high) / 2;
            (low, high) = at < _sums[middle] ? (low, middle) : (middle, high);
        }

        return (low, Math.Clamp((at - _sums[low]) / (_sums[low + 1] - _sums[low]), 0, 1 - 1e-16));
    }
}
