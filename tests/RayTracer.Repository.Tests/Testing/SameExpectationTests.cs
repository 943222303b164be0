using RayTracer.Imaging;
using RayTracer.Textures;
using Xunit.Sdk;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>The statistical assertion about images, on numbers that were made for it.</summary>
public sealed class SameExpectationTests : IDisposable
{
    private const int Width = 18;
    private const int Height = 13;
    private const string Name = "an expectation";
    private readonly TemporaryFolder _folder = new();

    private string Failure => Path.Combine(_folder.Path, "an_expectation");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Samples_of_one_expectation_pass_and_nothing_is_written()
    {
        ImageAssert.SameExpectation(Samples(1, 12, _ => 0), Samples(2, 16, _ => 0), ErrorBudget.Images, Name, output: _folder.Path);
        ImageAssert.SameExpectation(Samples(3, 12, _ => 0), Moments(4, 16, _ => 0), ErrorBudget.Images, Name, output: _folder.Path);
        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_planted_bias_is_found_with_its_block_and_pixel(bool moments)
    {
        // Pixels 9,5 and 10,6 lie in one block, of columns 8 to 11 and rows 4 to 7.
        TestFamily family = new("planted", 1e-3, 10, "nothing is planted");
        double Bias(int i) => i switch { (((5 * Width) + 9) * 3) + 1 => 4, (((6 * Width) + 10) * 3) + 1 => 9, _ => 0 };
        ImageSamples image = Samples(1, 16, Bias);
        ReplayScene scene = ReplayScene.Text("{}", "--spp", "64");
        string message = Assert.Throws<FailException>(() =>
        {
            if (moments)
            {
                ImageAssert.SameExpectation(image, Moments(2, 16, _ => 0), family, Name, scene, _folder.Path);
            }
            else
            {
                ImageAssert.SameExpectation(image, Samples(2, 16, _ => 0), family, Name, scene, _folder.Path);
            }
        }).Message;
        Assert.StartsWith($"{Name}: p = ", message, StringComparison.Ordinal);
        Assert.Contains("green of the 4×4 block at 8,4", message, StringComparison.Ordinal);
        Assert.EndsWith($"{Path.Combine(Failure, "scene.json")} --pixel 10,6 --spp 64", message, StringComparison.Ordinal);
        Assert.Equal(
            ["difference.pfm", "difference.png", "image.pfm", "image.png", "index.html", "pvalues.pfm", "pvalues.png", "reference.pfm", "reference.png", "scene.json"],
            Directory.GetFiles(Failure).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
        TestPictures.AssertSameBits(image.Mean(), ImageFile.Read(Path.Combine(Failure, "image.pfm")));
    }

    // But for what is planted, the samples are the same: then p = 1.
    [Fact]
    public void The_map_of_p_values_shows_the_block_and_nothing_else()
    {
        TestFamily family = new("planted", 1e-3, 10, "nothing is planted");
        Assert.Throws<FailException>(() => ImageAssert.SameExpectation(
            Samples(1, 16, i => i == ((5 * Width) + 9) * 3 ? 60 : 0), Samples(1, 16, _ => 0), family, Name, output: _folder.Path));
        Picture numbers = ImageFile.Read(Path.Combine(Failure, "pvalues.pfm"));
        Picture colours = ImageFile.Read(Path.Combine(Failure, "pvalues.png"), raw: true);
        for (int i = 0; i < numbers.Pixels.Length; i += 3)
        {
            bool planted = (i / 3 % Width / 4, i / 3 / Width / 4) == (2, 1);
            Assert.Equal(0, numbers.Pixels[i + 1]);
            Assert.InRange(numbers.Pixels[i], planted ? 15 : 0, planted ? 300 : 0);
            float[] expected = planted ? [1, 1, 1] : [20 / 255f, 20 / 255f, 45 / 255f];
            Assert.Equal(expected, colours.Pixels[i..(i + 3)]);
        }

        Assert.Contains("10<sup>−12</sup>", File.ReadAllText(Path.Combine(Failure, "index.html")), StringComparison.Ordinal);
    }

    [Fact]
    public void One_NaN_in_one_image_fails()
    {
        TestFamily family = new("planted", 1e-3, 10, "nothing is planted");
        string message = Assert.Throws<FailException>(() => ImageAssert.SameExpectation(
            Samples(1, 8, i => i == 99 ? double.NaN : 0), Samples(2, 8, _ => 0), family, Name, output: _folder.Path)).Message;
        Assert.Contains("p = 0", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Sets_of_other_sizes_fail()
    {
        ImageSamples other = new(3, 3);
        other.Add(new Picture(3, 3));
        string message = Assert.Throws<FailException>(() => ImageAssert.SameExpectation(Samples(1, 2, _ => 0), other, ErrorBudget.Images, Name, output: _folder.Path)).Message;
        Assert.Contains("the image has 18×13 pixels, the reference 3×3", message, StringComparison.Ordinal);
    }

    // Under the null hypothesis p-values of a block are uniform: here with unequal variances and few images.
    [Fact]
    public void P_values_against_a_mean_with_variance_are_uniform_where_nothing_is_wrong()
    {
        const int Runs = 400;
        int small = 0;
        for (int run = 0; run < Runs; run++)
        {
            ImageSamples image = Samples((2 * run) + 10, 6, _ => 0);
            ReferenceMoments reference = Moments((2 * run) + 11, 9, _ => 0);
            Block block = new(4, 4, 4, 4);
            small += BlockTest.Welch(image.Estimate(block, 0), reference.Estimate(block, 0)) < 0.1 ? 1 : 0;
        }

        ErrorBudget.NullRuns.Check(PValues.Binomial(small, Runs, 0.1), $"{small} of {Runs} p-values are below 0.1");
    }

    private static ImageSamples Samples(int seed, int count, Func<int, double> bias)
    {
        ImageSamples samples = new(Width, Height);
        foreach (Picture picture in Pictures(seed, count, bias))
        {
            samples.Add(picture);
        }

        return samples;
    }

    private static ReferenceMoments Moments(int seed, int count, Func<int, double> bias)
    {
        Picture[] pictures = [.. Pictures(seed, count, bias)];
        Picture mean = new(Width, Height);
        Picture variance = new(Width, Height);
        for (int i = 0; i < mean.Pixels.Length; i++)
        {
            double average = pictures.Average(p => (double)p.Pixels[i]);
            mean.Pixels[i] = (float)average;
            variance.Pixels[i] = (float)(pictures.Sum(p => (p.Pixels[i] - average) * (p.Pixels[i] - average)) / (count - 1) / count);
        }

        return new(mean, variance, count - 1);
    }

    // Uniform noise about 0, 0.1 … 0.6, with that plus a half as its width.
    private static IEnumerable<Picture> Pictures(int seed, int count, Func<int, double> bias)
    {
        Random random = new(seed + (TestSettings.Seed * 1_000_003));
        return Enumerable.Range(0, count).Select(_ => new Picture(
            Width, Height, [.. Enumerable.Range(0, 3 * Width * Height).Select(i => (float)(bias(i) + (i % 7 * 0.1) + ((random.NextDouble() - 0.5) * (0.5 + (i % 7 * 0.1)))))]));
    }
}
