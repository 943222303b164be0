namespace Lab5;

/// <summary>Russian roulette: paths that carry little mostly end, and those that go on make up for the others (Arvo and Kirk 1990).</summary>
public static class Roulette
{
    /// <summary>Decides whether a path goes on.</summary>
    /// <param name="throughput">The share of light that it carries; larger afterwards, where it goes on.</param>
    /// <param name="random">A random number from 0 to 1.</param>
    /// <returns>True where it goes on.</returns>
    public static bool Survives(ref Rgb throughput, double random)
    {
        //? Roulette.Survives: go on with a probability that is never 1, such as the largest channel or 0.95, and divide the throughput by it.
        double survival = Math.Min(throughput.Largest, 0.95);
        if (random >= survival)
        {
            return false;
        }

        throughput *= 1 / survival;
        return true;
        //!
    }
}
