using System.CommandLine;
using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer compare A B</c></summary>
internal static class CompareVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string[]> images = new("IMAGE") { Description = "The image to judge, and the reference.", Arity = new ArgumentArity(2, 2) };
        Option<string?> output = new("-o", "--output") { Description = "Writes the absolute difference as an image.", HelpName = "FILE" };
        ParsedOption<double?> tolerance = OptionValues.Number("--tolerance", "The largest root mean squared difference (linear light) that is no difference. Without it, any is.", 0, double.MaxValue);
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(images);
        command.Options.Add(output);
        command.Options.Add(tolerance.Symbol);
        command.Options.Add(json);
        command.SetAction(result => Compare(result.GetValue(images)!, result.GetValue(output), tolerance.Value(result), result.GetValue(json), streams));
    }

    private static int Compare(string[] paths, string? output, double? tolerance, bool json, Streams streams)
    {
        if (output is not null)
        {
            ImageOutputs.Check(output);
        }

        Picture image = ImageFile.Read(paths[0]);
        Picture reference = ImageFile.Read(paths[1]);
        if (image.Width != reference.Width || image.Height != reference.Height)
        {
            throw new CommandException(
                ExitStatus.Different, $"the images differ in size: {image.Width}×{image.Height} and {reference.Width}×{reference.Height} pixels");
        }

        ImageComparison comparison = ImageComparison.Compare(image, reference);
        if (output is not null)
        {
            ImageFile.Write(output, new DifferenceRows(image, reference));
        }

        bool isDifferent = tolerance is { } limit && !(comparison.Rmse <= limit && comparison.NotFinite == 0);
        if (json)
        {
            WriteJson(comparison, isDifferent, streams);
        }
        else
        {
            Write(comparison, streams);
        }

        return isDifferent ? ExitStatus.Different : ExitStatus.Fine;
    }

    private static void Write(ImageComparison comparison, Streams streams)
    {
        string channel = comparison.LargestChannel switch { 0 => "red", 1 => "green", _ => "blue" };
        streams.Output.WriteLine($"RMSE                {comparison.Rmse:G6}");
        streams.Output.WriteLine($"relative MSE        {comparison.RelativeMse:G6}");
        streams.Output.WriteLine($"PSNR                {(double.IsInfinity(comparison.Psnr) ? "infinite" : $"{comparison.Psnr:F2} dB")}");
        streams.Output.WriteLine($"SSIM                {(double.IsNaN(comparison.Ssim) ? "undefined below 11×11 pixels" : $"{comparison.Ssim:F6}")}");
        streams.Output.WriteLine($"largest difference  {comparison.LargestDifference:G6} ({channel} of pixel {comparison.LargestX},{comparison.LargestY})");
        if (comparison.NotFinite > 0)
        {
            streams.Warn($"{comparison.NotFinite} values are NaN or infinite and were left out");
        }
    }

    private static void WriteJson(ImageComparison comparison, bool isDifferent, Streams streams) => JsonText.Write(streams, json =>
    {
        JsonText.Number(json, "rmse", comparison.Rmse);
        JsonText.Number(json, "relativeMse", comparison.RelativeMse);
        JsonText.Number(json, "psnr", comparison.Psnr);
        JsonText.Number(json, "ssim", comparison.Ssim);
        JsonText.Number(json, "largestDifference", comparison.LargestDifference);
        json.WriteNumber("largestX", comparison.LargestX);
        json.WriteNumber("largestY", comparison.LargestY);
        json.WriteNumber("largestChannel", comparison.LargestChannel);
        json.WriteNumber("notFinite", comparison.NotFinite);
        json.WriteBoolean("differs", isDifferent);
    });
}
