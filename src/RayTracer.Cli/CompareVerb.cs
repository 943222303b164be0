using System.CommandLine;
using System.Text.Json.Nodes;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer compare A B</c></summary>
internal static class CompareVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> images = new("IMAGE") { Description = "The image to judge, and the reference.", Arity = new ArgumentArity(2, 2) };
        Option<string?> output = new("-o", "--output") { Description = "Writes the absolute difference as an image.", HelpName = "FILE" };
        Option<string?> map = new("--map") { Description = "Writes the FLIP error of each pixel as colours, with a scale.", HelpName = "FILE" };
        Option<string?> sheet = new("--side-by-side") { Description = "Writes both images and the FLIP errors beside each other, with labels and a scale.", HelpName = "FILE" };
        ParsedOption<double?> density = OptionValues.Number("--pixels-per-degree", "For FLIP: pixels per degree of the field of view. Default: 67, as for a display with 3840 columns seen from as far away as it is wide.", 1, 1000);
        ParsedOption<double?> tolerance = OptionValues.Number("--tolerance", "The largest root mean squared difference (linear light) that still counts as equal. Default: 0.", 0, double.MaxValue);
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(images);
        command.AddOptions(output, map, sheet, density, tolerance, json);
        VerboseOption verbose = new(command);
        command.SetAction(result => Compare(
            result.GetValue(images)!,
            new(result.GetValue(output), result.GetValue(map), result.GetValue(sheet)),
            density.Value(result) ?? FlipError.StandardPixelsPerDegree,
            tolerance.Value(result),
            result.GetValue(json),
            verbose.Times(result, streams),
            streams));
    }

    private static int Compare(
        string[] paths, Files files, double pixelsPerDegree, double? tolerance, bool json, StageTimes stages, Streams streams)
    {
        foreach (string file in new[] { files.Difference, files.Map, files.Sheet }.OfType<string>())
        {
            JobFiles.Check(file);
        }

        Picture image = ImageFile.Read(paths[0]);
        Picture reference = ImageFile.Read(paths[1]);
        stages.End(JobStage.Load);
        if (image.Width != reference.Width || image.Height != reference.Height)
        {
            throw new CommandException(
                ExitStatus.Different, $"the images differ in size: {image.Width}×{image.Height} and {reference.Width}×{reference.Height} pixels");
        }

        ImageComparison comparison = ImageComparison.Compare(image, reference);
        FlipError flip = FlipError.Compare(image, reference, pixelsPerDegree);
        stages.End("compare");
        Write(files.Difference, () => new DifferenceRows(image, reference));
        Write(files.Map, () => ComparisonSheet.Draw(flip));
        Write(files.Sheet, () => ComparisonSheet.Draw(image, Path.GetFileName(paths[0]), reference, Path.GetFileName(paths[1]), flip));
        stages.End(JobStage.Write);

        bool isDifferent = tolerance is { } limit && !(comparison.Rmse <= limit && comparison.NotFinite == 0);
        if (json)
        {
            JsonText.Write(streams, Json(comparison, flip, isDifferent));
        }
        else
        {
            Write(comparison, flip, streams);
        }

        return isDifferent ? ExitStatus.Different : ExitStatus.Fine;
    }

    private static void Write(string? path, Func<IImageRows> image)
    {
        if (path is not null)
        {
            ImageFile.Write(path, image());
        }
    }

    private static void Write(ImageComparison comparison, FlipError flip, Streams streams)
    {
        string channel = comparison.LargestChannel switch { 0 => "red", 1 => "green", _ => "blue" };
        streams.Output.WriteLine($"RMSE                {comparison.Rmse:G6}");
        streams.Output.WriteLine($"relative MSE        {comparison.RelativeMse:G6}");
        streams.Output.WriteLine($"PSNR                {(double.IsInfinity(comparison.Psnr) ? "infinite" : $"{comparison.Psnr:F2} dB")}");
        streams.Output.WriteLine(
            $"SSIM                {(double.IsNaN(comparison.Ssim) ? "undefined below 11×11 pixels" : $"{comparison.Ssim:F6}")}");
        streams.Output.WriteLine($"FLIP                {flip.Mean:F6}");
        streams.Output.WriteLine(
            $"largest difference  {comparison.LargestDifference:G6} ({channel} of pixel {comparison.LargestX},{comparison.LargestY})");
        if (comparison.NotFinite > 0)
        {
            streams.Warn($"{comparison.NotFinite} values are NaN or infinite and were left out");
        }
    }

    private static JsonObject Json(ImageComparison comparison, FlipError flip, bool isDifferent) => new()
    {
        ["rmse"] = JsonText.Number(comparison.Rmse),
        ["relativeMse"] = JsonText.Number(comparison.RelativeMse),
        ["psnr"] = JsonText.Number(comparison.Psnr),
        ["ssim"] = JsonText.Number(comparison.Ssim),
        ["flip"] = JsonText.Number(flip.Mean),
        ["largestDifference"] = JsonText.Number(comparison.LargestDifference),
        ["largestX"] = comparison.LargestX,
        ["largestY"] = comparison.LargestY,
        ["largestChannel"] = comparison.LargestChannel,
        ["notFinite"] = comparison.NotFinite,
        ["differs"] = isDifferent,
    };

    /// <summary>The files to write; null for none.</summary>
    /// <param name="Difference">The absolute difference.</param>
    /// <param name="Map">The map of FLIP errors.</param>
    /// <param name="Sheet">Both images and the map.</param>
    private sealed record Files(string? Difference, string? Map, string? Sheet);
}
