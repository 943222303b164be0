using System.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Shares samples out over blocks so that the mean squared error is least: in proportion to the deviation of one sample (Neyman 1934, for
/// strata of a survey).
/// </summary>
/// <param name="weights">The blocks' numbers of pixels.</param>
/// <param name="goal">The goal.</param>
/// <param name="fewest">The least samples of a pixel.</param>
internal sealed class SampleAllocation(double[] weights, SampleGoal goal, int fewest)
{
    private const int Bisections = 64;
    private readonly double _pixels = weights.Sum();

    /// <summary>Samples of a pixel, for each block.</summary>
    /// <param name="variances">Variance of one sample in each block.</param>
    /// <param name="deviations">Deviation of one sample that each block is given samples for.</param>
    /// <param name="budget">The most samples of all pixels together.</param>
    public int[] Share(double[] variances, double[] deviations, double budget)
    {
        double smallest = deviations.Where(d => d > 0).DefaultIfEmpty(1).Min();
        double scale = Change(goal.MostSamples / smallest, s => Total(deviations, s) <= budget).Last;
        if (goal.Error is { } wanted)
        {
            scale = Change(scale, s => Error(variances, deviations, s) > wanted * wanted).First;
        }

        return [.. deviations.Select(d => Samples(d, scale))];
    }

    /// <summary>The mean over all pixels of what blocks have.</summary>
    public double Mean(double[] values)
    {
        double sum = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            sum += weights[i] * values[i];
        }

        return sum / _pixels;
    }

    /// <summary>Mean squared error of a picture with some samples a pixel of each block.</summary>
    public double Error(double[] variances, IReadOnlyList<int> samples)
    {
        double sum = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            sum += weights[i] * variances[i] / samples[i];
        }

        return sum / _pixels;
    }

    // Where a condition that holds from 0 up to some number changes: the last number known to meet it, and the first known not to.
    private static (double Last, double First) Change(double limit, Func<double, bool> holds)
    {
        if (holds(limit))
        {
            return (limit, limit);
        }

        (double last, double first) = (0, limit);
        for (int i = 0; i < Bisections; i++)
        {
            double middle = (last + first) / 2;
            (last, first) = holds(middle) ? (middle, first) : (last, middle);
        }

        return (last, first);
    }

    private double Total(double[] deviations, double scale)
    {
        double sum = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            sum += weights[i] * Samples(deviations[i], scale);
        }

        return sum;
    }

    private double Error(double[] variances, double[] deviations, double scale)
    {
        double sum = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            sum += weights[i] * variances[i] / Samples(deviations[i], scale);
        }

        return sum / _pixels;
    }

    // Numbers with three binary digits that count: points of a stratified sampler are spread well after those.
    private int Samples(double deviation, double scale)
    {
        int wanted = (int)double.Clamp(double.Ceiling(deviation * scale), fewest, goal.MostSamples);
        int step = Math.Max(1, 1 << Math.Max(0, BitOperations.Log2((uint)wanted) - 2));
        return Math.Min(goal.MostSamples, (wanted + step - 1) / step * step);
    }
}
