using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer view IMAGE</c></summary>
internal static class ViewVerb
{
    private const int ColumnsWithoutTerminal = 80;

    public static void Build(Command command, Streams streams)
    {
        Argument<string> image = new("IMAGE") { Description = "The image file: PNG, JPEG, PFM, OpenEXR or Radiance HDR." };
        ParsedOption<long?> columns = OptionValues.Integer("--columns", "Number of terminal columns that the picture may take. Default: all (80 without a terminal).", 1, 10_000);
        ParsedOption<TerminalGraphics?> graphics = OptionValues.Choice<TerminalGraphics>("--as", "How the terminal shows it. Default: as TERM and similar variables say, and as letters under NO_COLOR.");
        JobOptionSet looks = new(JobOptions.OfLooks.Where(o => o.Feature == ImageFeatures.Display));
        command.Arguments.Add(image);
        command.AddOptions([columns, graphics, .. looks.Symbols]);

        command.SetAction(result =>
        {
            string path = result.GetValue(image)!;
            (Picture picture, IReadOnlyList<KeyValuePair<string, string>> texts, _) = ImageFile.ReadAll(path);
            ToneMappedRows seen = looks.Given(result).Writing.OfImage(path, texts).Shown(picture);
            TerminalGraphics how = graphics.Value(result) ?? TerminalPicture.Of(Environment.GetEnvironmentVariable);
            streams.Output.Write(TerminalPicture.Draw(seen, (int)(columns.Value(result) ?? Columns()), how));
            return ExitStatus.Fine;
        });
    }

    private static int Columns() => Console.IsOutputRedirected ? ColumnsWithoutTerminal : TerminalSize.Current.Columns;
}
