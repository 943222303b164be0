using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>FLIP: what its paper says of it, and the same numbers as its formulas written down plainly (in two dimensions, with the library's functions).</summary>
public sealed class FlipTests
{
    [Fact]
    public void Equal_images_have_no_error_and_order_does_not_matter()
    {
        Picture a = TestPictures.Noise(30, 20);
        Picture b = new(30, 20, [.. a.Pixels.Reverse()]);
        Assert.Equal(0, FlipError.Compare(a, a).Mean);
        FlipError one = FlipError.Compare(a, b);
        FlipError other = FlipError.Compare(b, a);
        ForEach(one, (x, y) => Assert.Equal(one[x, y], other[x, y]));
        ForEach(one, (x, y) => Assert.InRange(one[x, y], 0, 1));
        Assert.InRange(one.Mean, 0.01, 1);
    }

    [Fact]
    public void Green_and_blue_are_as_different_as_can_be()
    {
        // The largest distance of the uniform colours that a display has, to which errors are scaled.
        Assert.Equal(1, FlipError.Compare(Even(0, 1, 0), Even(0, 0, 1)).Mean, 1e-6);
        Assert.InRange(FlipError.Compare(Even(0, 0, 0), Even(1, 1, 1)).Mean, 0.9, 0.999);
    }

    [Fact]
    public void What_a_display_cannot_show_does_not_count()
    {
        Assert.Equal(0, FlipError.Compare(Even(2, 1, -1), Even(1, 30, 0)).Mean);
        Assert.Equal(0, FlipError.Compare(Even(float.NaN, 1, 0), Even(0, 1, 0)).Mean);
    }

    [Fact]
    public void A_spot_is_seen_as_far_as_the_eye_blurs_it_and_less_from_afar()
    {
        Picture grey = Even(0.5f, 0.5f, 0.5f, 60);
        Picture spot = Even(0.5f, 0.5f, 0.5f, 60);
        spot.Pixels.AsSpan(3 * ((30 * 60) + 30), 3).Fill(1);
        FlipError near = FlipError.Compare(spot, grey);
        FlipError far = FlipError.Compare(spot, grey, 200);
        ForEach(near, (x, y) => Assert.True((Math.Max(Math.Abs(x - 30), Math.Abs(y - 30)) <= 10) || near[x, y] < 1e-4));
        Assert.True(near[30, 30] > 3 * far[30, 30] && near[30, 30] == Enumerable.Range(0, 60).Max(i => near[i, 30]));
    }

    [Theory]
    [InlineData(67.0206)]
    [InlineData(25)]
    public void Errors_are_those_of_the_plain_formulas(double pixelsPerDegree)
    {
        Picture a = TestPictures.Noise(24, 18);
        Picture b = new(24, 18, [.. a.Pixels.Select((v, i) => i / 3 % 24 > 10 ? 0.8f * v : v + (i % 7 == 0 ? 0.3f : 0))]);
        FlipError error = FlipError.Compare(a, b, pixelsPerDegree);
        double[] plain = new PlainFlip(pixelsPerDegree).Compare(a, b);
        ForEach(error, (x, y) => Assert.Equal(plain[(y * 24) + x], error[x, y], 2e-5));
    }

    [Fact]
    public void A_sheet_holds_both_images_the_map_and_labels()
    {
        Picture a = TestPictures.Noise(160, 50);
        Picture b = Even(0.5f, 0.5f, 0.5f, 160, 50);
        FlipError error = FlipError.Compare(a, b);
        Picture sheet = ComparisonSheet.Draw(a, "first.exr", b, "SECOND (1)", error);
        Assert.Equal(3 * (160 + 8) + 8, sheet.Width);
        float[] row = new float[3 * 160];
        for (int y = 0; y < 50; y++)
        {
            for (int panel = 0; panel < 3; panel++)
            {
                (panel == 0 ? a : panel == 1 ? b : (IImageRows)error).ReadRow(y, row);
                Assert.Equal(row, sheet.Pixels.AsSpan(3 * (((18 + y) * sheet.Width) + 8 + (panel * 168)), 480).ToArray());
            }
        }

        // Ink above the panels, and the colours of the scale below the map, from the first to the last.
        Assert.All([8, 176, 344], left => Assert.Contains(0.8f, sheet.Pixels.AsSpan(3 * ((11 * sheet.Width) + left), 300).ToArray()));
        int scale = 3 * ((72 * sheet.Width) + 344);
        Assert.True(sheet.Pixels[scale] < 0.01f && sheet.Pixels[scale + (3 * 159)] > 0.9f);
    }

    private static void ForEach(FlipError error, Action<int, int> action)
    {
        for (int i = 0; i < error.Width * error.Height; i++)
        {
            action(i % error.Width, i / error.Width);
        }
    }

    private static Picture Even(float r, float g, float b, int width = 12, int height = 0)
    {
        Picture picture = new(width, height > 0 ? height : width);
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            picture.Pixels[i] = i % 3 == 0 ? r : i % 3 == 1 ? g : b;
        }

        return picture;
    }
}
