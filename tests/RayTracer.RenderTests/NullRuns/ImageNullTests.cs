using RayTracer.Description;
using RayTracer.RenderTests.References;
using RayTracer.Textures;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.NullRuns;

/// <summary>
/// Comparisons of images whose expectations are the same: one scene, other seeds and other samplers.
/// Covers `SobolSampler`, `JitteredSampler` and `IndependentSampler`.
/// </summary>
[Trait("Category", "Thorough")]
public class ImageNullTests(ITestOutputHelper output)
{
    private const int Seeds = 32;

    // Penumbra, indirect light, a caustic, outlines and sky.
    private const string Scene = """
        {
          "camera": { "position": [0, 1.5, 5], "lookAt": [0, 0.6, 0], "fieldOfView": 40 },
          "render": { "integrator": "report", "width": 16, "height": 16, "samplesPerPixel": 4, "maxDiffuseDepth": 2, "maxSpecularDepth": 3 },
          "background": [0.2, 0.25, 0.3],
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "size": [6, 6], "material": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } },
            { "type": "sphere", "center": [-0.6, 0.6, 0], "radius": 0.6, "material": { "type": "diffuse", "color": [0.8, 0.3, 0.2] } },
            { "type": "sphere", "center": [0.7, 0.5, 0.6], "radius": 0.5, "material": { "type": "dielectric" } }
          ],
          "lights": [
            { "type": "sphere", "center": [1.5, 3, 1], "radius": 0.4, "material": { "type": "luminaire", "color": [10, 9, 8] } }
          ]
        }
        """;

    [Fact]
    [Trait("Category", "Slow")]
    public void Images_of_one_expectation_differ_no_more_often_than_the_comparison_says()
    {
        Block middle = new(4, 8, 4, 4);
        Block edge = new(4, 4, 4, 4);
        Block all = new(0, 0, 16, 16);
        NullRun.Check("images", output, 30, run =>
        {
            ImageSamples independent = Render(SamplerKind.Independent, Seeds, (100 * run) + 1);
            ImageSamples sobol = Render(SamplerKind.Sobol, 16, (100 * run) + 51);
            ReferenceComparison reference = new("null", sobol, Moments(independent).Estimate);
            return
            [
                ("independent against sobol", BlockTest.Compare(independent, sobol).P),
                ("a block", BlockTest.Welch(independent.Estimate(middle, 1), sobol.Estimate(middle, 1))),
                ("the mean", BlockTest.Welch(independent.Estimate(all, 0), sobol.Estimate(all, 0))),
                ("pixels' variances as a reference", reference.Test().P),
                ("pixels' variances, a block", BlockTest.Welch(sobol.Estimate(middle, 1), reference.Reference(middle, 1))),
                ("pixels' variances, a block at an outline", BlockTest.Welch(sobol.Estimate(edge, 2), reference.Reference(edge, 2))),
                ("pixels' variances, the mean", BlockTest.Welch(sobol.Estimate(all, 0), reference.Reference(all, 0))),
            ];
        });
    }

    private static ImageSamples Render(SamplerKind sampler, int seeds, int firstSeed) =>
        SceneRuns.RenderText(Scene, seeds, d => d with { Render = d.Render with { Sampler = sampler } }, firstSeed);

    // What the references are: a mean image, and the variance of each of its pixels.
    private static ReferenceMoments Moments(ImageSamples images)
    {
        Picture variance = new(images.Width, images.Height);
        foreach (Block pixel in Block.Cut(images.Width, images.Height, 1))
        {
            for (int channel = 0; channel < 3; channel++)
            {
                variance.Pixels[(3 * ((pixel.Y * images.Width) + pixel.X)) + channel] = (float)images.Estimate(pixel, channel).Variance;
            }
        }

        return new(images.Mean(), variance, images.Count - 1);
    }
}
