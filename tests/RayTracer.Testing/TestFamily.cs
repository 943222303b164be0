using System.Globalization;
using Xunit;

namespace RayTracer.Testing;

/// <summary>
/// Statistical tests that share a part of the suite's error budget. Each of its p-values may raise a false alarm with
/// probability <see cref="Level"/> at most; by Bonferroni's inequality, the family as a whole with <see cref="Alpha"/> at most,
/// however its tests depend on one another.
/// </summary>
/// <param name="name">A word for messages.</param>
/// <param name="alpha">Probability that any test of the family fails though nothing is wrong.</param>
/// <param name="tests">Number of p-values that one run checks at most, in a thorough run; more are an error.</param>
/// <param name="nullHypothesis">What holds where nothing is wrong.</param>
public sealed class TestFamily(string name, double alpha, int tests, string nullHypothesis)
{
    private int _checked;

    /// <summary>A word for messages.</summary>
    public string Name => name;

    /// <summary>Probability that any test of the family fails though nothing is wrong.</summary>
    public double Alpha => alpha;

    /// <summary>Number of p-values that one run checks at most.</summary>
    public int Tests => tests;

    /// <summary>What holds where nothing is wrong.</summary>
    public string NullHypothesis => nullHypothesis;

    /// <summary>The p-value below which a single test fails.</summary>
    public double Level => alpha / tests;

    /// <summary>Fails if a p-value is too small to be chance.</summary>
    /// <param name="p">The p-value; where it is the smallest of several, times their number. NaN fails.</param>
    /// <param name="what">What was tested, for the message.</param>
    /// <param name="details">Makes further lines of the message; called only on failure.</param>
    public void Check(double p, string what, Func<string>? details = null)
    {
        if (Interlocked.Increment(ref _checked) > tests)
        {
            Assert.Fail($"The error budget of \"{name}\" is for {tests} p-values; this is one more: {what}. Raise the number in ErrorBudget.cs.");
        }

        if (!(p >= Level))
        {
            string message = string.Create(CultureInfo.InvariantCulture, $"{what}: p = {p:G3}, below the level {Level:G3} of \"{name}\" ({nullHypothesis}).");
            Assert.Fail(details is null ? message : $"{message}\n{details()}");
        }
    }
}
