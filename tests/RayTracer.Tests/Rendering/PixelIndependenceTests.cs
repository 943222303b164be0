using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>A pixel's samples say nothing about its neighbours'. Covers `RayGenerator` and `Sampler`.</summary>
public class PixelIndependenceTests
{
    private const int Edge = 96;

    [Theory]
    [InlineData("independent")]
    [InlineData("jittered")]
    [InlineData("sobol")]
    public void Neighbouring_pixels_are_uncorrelated(string sampler)
    {
        // Through so narrow a view all pixels see one point, lit by one sample of a large lamp: they differ by their random numbers alone.
        Film film = new RTracer(TestScenes.Build($$"""
            {
              "camera": { "position": [0, 2, 3], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "integrator": "report", "width": {{Edge}}, "height": {{Edge}}, "samplesPerPixel": 1, "sampler": "{{sampler}}", "seed": {{TestSettings.Seed}} },
              "shapes": [{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } }],
              "lights": [{ "type": "sphere", "center": [0.5, 2, 0.5], "radius": 1, "material": { "type": "luminaire", "color": [1, 1, 1], "multiplier": 5, "exponent": 1 } }]
            }
            """)).Render().Film;
        double[,] value = new double[Edge, Edge];
        double mean = 0;
        ForEachPixel(0, 0, (x, y) => mean += film.Mean(x, y).G / (Edge * (double)Edge));
        double variance = 0;
        ForEachPixel(0, 0, (x, y) =>
        {
            value[x, y] = film.Mean(x, y).G - mean;
            variance += value[x, y] * value[x, y] / (Edge * (double)Edge);
        });
        Assert.True(variance > 1e-4 * mean * mean, "the samples do not differ");
        ErrorBudget.Samplers.Check(
            PValues.Smallest(new[] { (1, 0), (0, 1), (1, 1), (2, 0), (0, 2), (8, 0) }.Select(step =>
            {
                (double sum, int pairs) = (0, 0);
                ForEachPixel(step.Item1, step.Item2, (x, y) =>
                {
                    sum += value[x, y] * value[x + step.Item1, y + step.Item2];
                    pairs++;
                });
                return PValues.Normal(sum / variance / Math.Sqrt(pairs));
            })),
            $"neighbouring pixels with the {sampler} sampler");
    }

    private static void ForEachPixel(int right, int down, Action<int, int> action)
    {
        for (int y = 0; y < Edge - down; y++)
        {
            for (int x = 0; x < Edge - right; x++)
            {
                action(x, y);
            }
        }
    }
}
