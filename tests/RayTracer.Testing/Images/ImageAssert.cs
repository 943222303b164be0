using RayTracer.Imaging;
using RayTracer.Textures;
using Xunit;

namespace RayTracer.Testing;

/// <summary>
/// Assertions about images. Each that fails leaves a folder with image, reference, signed difference and, where the comparison is
/// statistical, p-values, and a page that says what is what; the message names it, and the command that renders the worst pixel
/// again. The folder is <c>artifacts/test-failures/NAME</c> in the project, or lies in the one that the environment variable
/// <c>RAYTRACER_TEST_OUTPUT</c> names. One that cannot be written is named in the message, and changes nothing else.
/// </summary>
public static class ImageAssert
{
    /// <summary>An image equals its reference, by a rule.</summary>
    /// <param name="image">The image to judge; linear RGB.</param>
    /// <param name="reference">What it should be; linear RGB.</param>
    /// <param name="rule">What counts as equal: <see cref="ImageRule.Exact"/>, <see cref="ImageRule.Within"/>, <see cref="ImageRule.LooksLike"/>.</param>
    /// <param name="name">A name of this comparison that no other one has: it becomes that of a folder.</param>
    /// <param name="scene">What the image was rendered from, for the command; null for none.</param>
    /// <param name="output">Where the folder is made; by default <see cref="FailureFolder.Default"/>.</param>
    public static void Matches(IImageRows image, IImageRows reference, ImageRule rule, string name, ReplayScene? scene = null, string? output = null)
    {
        Picture a = Copy(image);
        Picture b = Copy(reference);
        ImageVerdict verdict = FailureFolder.SameSize(a, b) ? rule.Judge(a, b) : WrongSize(a, b);
        if (!verdict.Passes)
        {
            Fail(new(name, verdict.Finding, a, b, verdict.Worst % a.Width, verdict.Worst / a.Width, null, scene), output);
        }
    }

    /// <summary>
    /// An image equals a reference file, by a rule. Where the environment variable <c>RAYTRACER_UPDATE</c> is 1 the file is written,
    /// again or for the first time: look at it before it is committed. PFM and OpenEXR keep all bits; PNG has 16, of light from 0 to 1.
    /// </summary>
    /// <param name="image">The image to judge; linear RGB.</param>
    /// <param name="path">The reference, a .pfm, .exr or .png file.</param>
    /// <param name="rule">What counts as equal.</param>
    /// <param name="scene">What the image was rendered from, for the command; null for none.</param>
    /// <param name="output">Where a failure's folder is made, which has the file's name; by default <see cref="FailureFolder.Default"/>.</param>
    /// <param name="update">Whether to write the file; by default what <c>RAYTRACER_UPDATE</c> says.</param>
    public static void MatchesFile(IImageRows image, string path, ImageRule rule, ReplayScene? scene = null, string? output = null, bool? update = null)
    {
        string name = Path.GetFileNameWithoutExtension(path);
        if (update ?? Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1")
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
            ImageFile.Write(path, image, new() { BitDepth = 16, ExrPixelType = ExrPixelType.Float });
        }

        Picture reference;
        try
        {
            reference = ImageFile.Read(path);
        }
        catch (PictureException e)
        {
            string finding = $"{e.Message} If the image is right, run the test once with RAYTRACER_UPDATE=1 to write it as the reference.";
            Fail(new(name, finding, Copy(image), null, 0, 0, null, scene), output);
            throw;
        }

        Matches(image, reference, rule, name, scene, output);
    }

    /// <summary>Two sets of independent images have the same expectation: <see cref="BlockTest"/>, checked by a family of the error budget.</summary>
    /// <param name="image">The images to judge, two at least.</param>
    /// <param name="reference">What they should be, two at least.</param>
    /// <param name="family">Fails if the p-value is too small to be chance; one p-value of its budget is used.</param>
    /// <param name="name">A name of this comparison that no other one has: it becomes that of a folder.</param>
    /// <param name="scene">What the images were rendered from, for the command; null for none.</param>
    /// <param name="output">Where the folder is made; by default <see cref="FailureFolder.Default"/>.</param>
    public static void SameExpectation(ImageSamples image, ImageSamples reference, TestFamily family, string name, ReplayScene? scene = null, string? output = null) =>
        SameExpectation(image, reference.Mean(), reference.Estimate, family, name, scene, output);

    /// <summary>A set of independent images has the expectation of a reference that is known by its mean and the variance of that mean.</summary>
    /// <inheritdoc cref="SameExpectation(ImageSamples, ImageSamples, TestFamily, string, ReplayScene?, string?)"/>
    public static void SameExpectation(ImageSamples image, ReferenceMoments reference, TestFamily family, string name, ReplayScene? scene = null, string? output = null) =>
        SameExpectation(image, reference.Mean, reference.Estimate, family, name, scene, output);

    /// <summary>A set of independent images has an expectation that can be estimated for every block.</summary>
    /// <param name="image">The images to judge, two at least.</param>
    /// <param name="mean">The reference as an image, for the pictures of a failure.</param>
    /// <param name="reference">Estimates a channel of a block of the reference.</param>
    /// <param name="family">Fails if the p-value is too small to be chance; one p-value of its budget is used.</param>
    /// <param name="name">A name of this comparison that no other one has: it becomes that of a folder.</param>
    /// <param name="scene">What the images were rendered from, for the command; null for none.</param>
    /// <param name="output">Where the folder is made; by default <see cref="FailureFolder.Default"/>.</param>
    public static void SameExpectation(
        ImageSamples image, Picture mean, Func<Block, int, BlockEstimate> reference, TestFamily family, string name, ReplayScene? scene = null, string? output = null)
    {
        Picture own = image.Mean();
        if (!FailureFolder.SameSize(own, mean))
        {
            Fail(new(name, WrongSize(own, mean).Finding, own, mean, 0, 0, null, scene), output);
        }

        BlockTest test = BlockTest.Compare(image.Width, image.Height, image.Estimate, reference);
        family.Check(test.P, name, () =>
        {
            (int x, int y) = WorstPixel(test, own, mean);
            PValueMap map = new(image.Width, image.Height, image.Estimate, reference);
            return new ImageFailure(name, test.ToString(), own, mean, x, y, map, scene).Report(output);
        });
    }

    private static void Fail(ImageFailure failure, string? output) => Assert.Fail($"{failure.Name}: {failure.Report(output)}");

    // Of the worst block, the pixel that is furthest off in the direction in which the block is.
    private static (int X, int Y) WorstPixel(BlockTest test, Picture image, Picture reference)
    {
        Block b = test.Worst;
        int sign = test.Image.Mean < test.Reference.Mean ? -1 : 1;
        return Enumerable.Range(0, b.Width * b.Height).Select(i => (X: b.X + (i % b.Width), Y: b.Y + (i / b.Width))).MaxBy(p =>
        {
            int i = (3 * ((p.Y * image.Width) + p.X)) + test.Channel;
            float off = sign * (image.Pixels[i] - reference.Pixels[i]);
            return float.IsNaN(off) ? float.PositiveInfinity : off;
        });
    }

    private static ImageVerdict WrongSize(Picture image, Picture reference) =>
        new(false, $"the image has {image.Width}×{image.Height} pixels, the reference {reference.Width}×{reference.Height}", 0);

    private static Picture Copy(IImageRows image)
    {
        Picture copy = new(image.Width, image.Height);
        for (int y = 0; y < image.Height; y++)
        {
            image.ReadRow(y, copy.Pixels.AsSpan(3 * y * image.Width, 3 * image.Width));
        }

        return copy;
    }
}
