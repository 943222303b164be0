using System.Globalization;

namespace RayTracer.Testing;

/// <summary>What the environment asks of the tests.</summary>
public static class TestSettings
{
    private static readonly string s_thorough = Environment.GetEnvironmentVariable("RAYTRACER_THOROUGH") ?? "";

    /// <summary>
    /// Whether <c>RAYTRACER_THOROUGH</c> asks for more seeds, angles and samples: <c>1</c> for all of them, <c>some</c> for as many as CI has time for.
    /// </summary>
    public static bool Thorough { get; } = s_thorough is "1" or "some";

    /// <summary>
    /// Selects the random numbers of all statistical tests: <c>RAYTRACER_TEST_SEED</c>, by default 0. The tests must hold with
    /// any seed, up to the error budget.
    /// </summary>
    public static int Seed { get; } =
        int.TryParse(Environment.GetEnvironmentVariable("RAYTRACER_TEST_SEED"), CultureInfo.InvariantCulture, out int seed) ? seed : 0;

    /// <summary>One number for every day, and another for a thorough run; a third of the way between their logarithms where that has little time.</summary>
    public static int Scale(int everyday, int thorough) => s_thorough == "some" ? Between(everyday, thorough) : Thorough ? thorough : everyday;

    // A power of two between powers of two, and a square between squares: some sequences of samples need them, or both.
    private static int Between(int a, int b)
    {
        bool areSquares = double.IsInteger(double.Sqrt(a)) && double.IsInteger(double.Sqrt(b));
        if (int.IsPow2(a) && int.IsPow2(b))
        {
            int power = ((2 * int.Log2(a)) + int.Log2(b)) / 3;
            return 1 << (areSquares ? power + (power % 2) : power);
        }

        double between = double.Cbrt((double)a * a * b);
        int edge = (int)double.Round(double.Sqrt(between));
        return areSquares ? edge * edge : (int)double.Round(between);
    }
}
