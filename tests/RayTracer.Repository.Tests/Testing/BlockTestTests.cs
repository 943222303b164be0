using RayTracer.Textures;

namespace RayTracer.Repository.Tests.Testing;

/// <summary>The comparison of images finds what was planted, and says where.</summary>
public class BlockTestTests
{
    private const int Edge = 32;
    private const double Level = 1e-6;

    [Fact]
    public void A_block_that_is_one_per_cent_brighter_is_found_and_named()
    {
        BlockTest test = BlockTest.Compare(Images(1, 0.005, (x, y, c) => x is >= 8 and < 12 && y is >= 20 and < 24 && c == 1 ? 1.01 : 1), Images(2, 0.005));
        Assert.True(test.P < Level, test.ToString());
        Assert.Equal((new Block(8, 20, 4, 4), 1), (test.Worst, test.Channel));
        Assert.Contains("green of the 4×4 block at 8,20", test.ToString(), StringComparison.Ordinal);
    }

    // A deviation of 2 % in pixels leaves 0.5 % of energy within three deviations in blocks of 4×4.
    [Fact]
    public void An_image_that_loses_half_a_per_cent_is_found_by_its_mean()
    {
        BlockTest test = BlockTest.Compare(Images(3, 0.02, (_, _, _) => 0.995), Images(4, 0.02));
        Assert.True(test.P < Level, test.ToString());
        Assert.Equal(new Block(0, 0, Edge, Edge), test.Worst);
    }

    [Fact]
    public void One_value_that_is_not_a_number_is_a_difference()
    {
        BlockTest test = BlockTest.Compare(Images(5, 0.1, (x, y, c) => (x, y, c) == (5, 6, 2) ? double.NaN : 1), Images(6, 0.1));
        Assert.Equal(0, test.P);
        Assert.Equal(2, test.Channel);
    }

    [Theory]
    [InlineData(1 + 5e-6, 1)]
    [InlineData(1 + 5e-5, 0)]
    public void Images_without_noise_may_differ_by_rounding_only(double factor, double p) =>
        Assert.Equal(p, BlockTest.Compare(Images(7, 0, (_, _, _) => factor), Images(8, 0)).P);

    [Fact]
    public void Equal_variances_have_the_degrees_of_freedom_of_both()
    {
        // t of 2.042 is at 5 % with 30 degrees of freedom; rounding is allowed for.
        double off = (2.042 * Math.Sqrt(2)) + BlockTest.AbsoluteTolerance;
        Assert.Equal(0.05, BlockTest.Welch(new(off, 1, 15), new(0, 1, 15)), 4);

        // With all variance on one side, the degrees of freedom are that side's: 15, and 2.131.
        Assert.Equal(0.05, BlockTest.Welch(new(2.131 + BlockTest.AbsoluteTolerance, 1, 15), new(0, 0, 15)), 4);
    }

    [Fact]
    public void Blocks_cover_every_pixel_once()
    {
        Block[] blocks = [.. Block.Cut(10, 7, 4)];
        IEnumerable<(int, int)> pixels = blocks.SelectMany(b => from y in Enumerable.Range(b.Y, b.Height) from x in Enumerable.Range(b.X, b.Width) select (x, y));
        Assert.Equal(from y in Enumerable.Range(0, 7) from x in Enumerable.Range(0, 10) select (x, y), pixels.OrderBy(p => p.Item2).ThenBy(p => p.Item1));
        Assert.Equal(6, blocks.Length);
    }

    // One image has 1 and 3, the other 2 and 6: means 2 and 4, their mean 3, its variance 2 / 2.
    [Fact]
    public void A_block_has_the_mean_of_its_images_and_the_variance_of_that_mean()
    {
        ImageSamples images = new(2, 1);
        images.Add(new Picture(2, 1, [1, 0, 5, 3, 0, 5]));
        images.Add(new Picture(2, 1, [2, 0, 5, 6, 0, 5]));
        Assert.Equal(new BlockEstimate(3, 1, 1), images.Estimate(new(0, 0, 2, 1), 0));
        Assert.Equal(new BlockEstimate(5, 0, 1), images.Estimate(new(0, 0, 2, 1), 2));
        Assert.Equal([1.5f, 0, 5, 4.5f, 0, 5], images.Mean().Pixels);
        Assert.Throws<ArgumentException>(() => images.Add(new Picture(1, 2)));
    }

    private static ImageSamples Images(int seed, double deviation, Func<int, int, int, double>? factor = null)
    {
        // Sums of twelve uniform numbers, less 6, are all but normal, with variance 1.
        Random random = new(seed + TestSettings.Seed);
        ImageSamples images = new(Edge, Edge);
        for (int i = 0; i < 16; i++)
        {
            Picture picture = new(Edge, Edge);
            for (int j = 0; j < picture.Pixels.Length; j++)
            {
                double normal = Enumerable.Range(0, 12).Sum(_ => random.NextDouble()) - 6;
                picture.Pixels[j] = (float)((factor?.Invoke(j / 3 % Edge, j / 3 / Edge, j % 3) ?? 1) * (1 + (deviation * normal)));
            }

            images.Add(picture);
        }

        return images;
    }
}
