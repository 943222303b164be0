using System.Globalization;

namespace RayTracer.Testing;

/// <summary>What the environment asks of the tests.</summary>
public static class TestSettings
{
    /// <summary>Whether <c>RAYTRACER_THOROUGH=1</c> asks for more seeds, angles and samples.</summary>
    public static bool Thorough { get; } = Environment.GetEnvironmentVariable("RAYTRACER_THOROUGH") == "1";

    /// <summary>
    /// Selects the random numbers of all statistical tests: <c>RAYTRACER_TEST_SEED</c>, by default 0. The tests must hold with
    /// any seed, up to the error budget.
    /// </summary>
    public static int Seed { get; } =
        int.TryParse(Environment.GetEnvironmentVariable("RAYTRACER_TEST_SEED"), CultureInfo.InvariantCulture, out int seed) ? seed : 0;

    /// <summary>One number for every day, and another for a thorough run.</summary>
    public static int Scale(int everyday, int thorough) => Thorough ? thorough : everyday;
}
