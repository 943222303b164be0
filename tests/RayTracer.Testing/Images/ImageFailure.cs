using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>What a failed comparison leaves behind: a folder with pictures, and a command.</summary>
/// <param name="Name">The test.</param>
/// <param name="Finding">What is wrong, in one line.</param>
/// <param name="Image">The image, or the mean of the images.</param>
/// <param name="Reference">The reference, or its mean; null where there is none.</param>
/// <param name="X">Column of the worst pixel.</param>
/// <param name="Y">Row of the worst pixel.</param>
/// <param name="PValues">Where the images disagree; null where the comparison is not statistical.</param>
/// <param name="Scene">What the image was rendered from; null where that is unknown.</param>
internal sealed record ImageFailure(string Name, string Finding, Picture Image, Picture? Reference, int X, int Y, PValueMap? PValues, ReplayScene? Scene)
{
    private const string Page = "index.html";

    /// <summary>Rewrites the folder, and returns the lines of the message: what is wrong, where the pictures are, how to replay.</summary>
    /// <param name="output">The folder of such folders; null for the usual one (<see cref="FailureFolder.Default"/>).</param>
    public string Report(string? output)
    {
        string folder = FailureFolder.Of(Name, output);
        string replay = Scene is null ? "" : $"\nreplay the worst pixel: {Scene.Command(folder, X, Y)}";
        try
        {
            Write(folder, replay);
            return $"{Finding}\nimage, reference and difference: {Path.Combine(folder, Page)}{replay}";
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            // Whatever hinders the writing must not hide what the test found.
            return $"{Finding}\n(no pictures, for '{folder}' cannot be written: {e.Message}){replay}";
        }
    }

    private void Write(string folder, string replay)
    {
        Directory.CreateDirectory(folder);
        foreach (string old in Pictures().Select(p => p.File).Concat([Page, ReplayScene.FileName]))
        {
            File.Delete(Path.Combine(folder, old));
        }

        var pictures = Pictures().Where(p => p.Content is not null).ToArray();
        foreach ((string file, _, Picture? content) in pictures)
        {
            ImageFile.Write(Path.Combine(folder, file), content!);
        }

        if (Scene?.Content is { } json)
        {
            File.WriteAllText(Path.Combine(folder, ReplayScene.FileName), json);
        }

        string page = FailurePage.Html(this, replay.Trim(), [.. pictures.Select(p => (p.File, p.What))]);
        File.WriteAllText(Path.Combine(folder, Page), page);
    }

    private IEnumerable<(string File, string What, Picture? Content)> Pictures()
    {
        SignedDifference? difference = Reference is null || !FailureFolder.SameSize(Image, Reference) ? null : new(Image, Reference);
        yield return ("image.png", "image", Image);
        yield return ("image.pfm", "image", Image);
        yield return ("reference.png", "reference", Reference);
        yield return ("reference.pfm", "reference", Reference);
        yield return ("difference.png", $"image − reference: grey is equal, brighter is more, darker is less; black and white are ∓{difference?.Range:G3} and beyond, NaN and infinity are magenta", difference?.Shown());
        yield return ("difference.pfm", "image − reference", difference?.Numbers);
        yield return ("pvalues.png", "p-values of blocks of 4×4 pixels", PValues?.Colours());
        yield return ("pvalues.pfm", "−log₁₀ p of blocks of 4×4 pixels, channel by channel", PValues?.Numbers());
    }
}
