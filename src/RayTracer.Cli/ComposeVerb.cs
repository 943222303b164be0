using System.CommandLine;
using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer compose IMAGE --light NAME=FACTOR -o FILE</c>: rebalances the lights of a picture.</summary>
internal static class ComposeVerb
{
    private const int MostNames = 20;

    // Halves are off by half a unit in eleven bits; layers that lack more are not all of the picture.
    private const double MostMissing = 1e-3;

    public static void Build(Command command, Streams streams)
    {
        Argument<string> image = new("IMAGE") { Description = "An OpenEXR file with layers of lights, as render --aov lights writes it." };
        Option<string[]> lights = new("--light") { Description = "The factor for a light: a number, or three for red, green and blue. Repeatable.", HelpName = "NAME=X|NAME=R,G,B" };
        ParsedOption<double?> others = OptionValues.Number("--others", "The factor for all lights that are not named. Default: 1.", 0, 1e6);
        WritingOptions output = new(command, $"The image file: {ImageFormat.Endings()}. Repeatable.");
        command.Arguments.Add(image);
        command.AddOptions([lights, others, .. output.Looks]);

        VerboseOption verbose = new(command);
        command.SetAction(result =>
        {
            ImageWriteOptions writing = output.Writing(result) with { Metadata = PictureTexts.Of(CommandLine.Text(result)) };
            output.WarnOfUnused(result, output.Files(result), streams);
            return Compose(result.GetValue(image)!, output.Files(result), result.GetValue(lights) ?? [], (float)(others.Value(result) ?? 1), writing, verbose.Times(result, streams), streams);
        });
    }

    private static int Compose(string path, IReadOnlyList<string> outputs, string[] words, float others, ImageWriteOptions writing, StageTimes stages, Streams streams)
    {
        (string Word, string Light, Rgb Factor)[] factors = [.. words.Select(Parse)];
        foreach (string file in outputs)
        {
            JobFiles.Check(file);
        }

        Picture? composed = OfFile<Picture?>(path, file =>
        {
            RelightableImage mix = RelightableImage.Open(file);
            stages.End(JobStage.Load);
            Dictionary<string, Rgb> byLight = ByLight(factors, mix.Lights, path);
            if (outputs.Count == 0 && words.Length == 0)
            {
                streams.Output.WriteLine(string.Join(Environment.NewLine, mix.Lights));
                return null;
            }

            if (outputs.Count == 0)
            {
                throw new CommandException(ExitStatus.Usage, $"where to? Give -o FILE. The lights of '{path}' are {Names(mix.Lights)}");
            }

            if (mix.Missing() is > MostMissing and var missing)
            {
                streams.Warn($"the lights of '{path}' do not add up to its picture: the difference is {missing:P1}");
            }

            return mix.Compose(light => byLight.GetValueOrDefault(light, new(others, others, others)));
        });
        if (composed is null)
        {
            return ExitStatus.Fine;
        }

        stages.End("compose");
        int written = JobFiles.Write(outputs, composed, writing.OfImage(path, ImageFile.ReadText(path)), streams).Count;
        stages.End(JobStage.Write);
        return written < outputs.Count ? ExitStatus.InputOutput : ExitStatus.Fine;
    }

    private static T OfFile<T>(string path, Func<byte[], T> read)
    {
        try
        {
            InputFiles.Add(path);
            return read(File.ReadAllBytes(path));
        }
        catch (PictureException e)
        {
            throw new PictureException(
                $"Cannot balance the lights of '{path}': {e.Message} (raytracer render SCENE --aov lights -o FILE.exr writes them)", e);
        }
    }

    private static (string Word, string Light, Rgb Factor) Parse(string word)
    {
        int equals = word.LastIndexOf('=');
        if (equals < 1)
        {
            throw new CommandException(ExitStatus.Usage, $"--light {word}: expected NAME=X or NAME=R,G,B");
        }

        float[] values = [.. word[(equals + 1)..].Split(',').Select(part =>
            float.TryParse(part, NumberStyles.Float, CultureInfo.InvariantCulture, out float value) && value is >= 0 and <= 1e6f ? value
            : throw new CommandException(
                ExitStatus.Usage, $"--light {word}: expected a number from 0 to 1000000, not {Quotation.Of(part)}"))];
        return values switch
        {
            [var grey] => (word, word[..equals], new(grey, grey, grey)),
            [var r, var g, var b] => (word, word[..equals], new(r, g, b)),
            _ => throw new CommandException(ExitStatus.Usage, $"--light {word}: expected one number or three, not {values.Length}"),
        };
    }

    private static Dictionary<string, Rgb> ByLight(
        (string Word, string Light, Rgb Factor)[] factors, IReadOnlyList<string> lights, string path)
    {
        Dictionary<string, Rgb> byLight = [];
        foreach ((string word, string light, Rgb factor) in factors)
        {
            string name = lights.Contains(light) ? light : LightPathAovFilm.NameOf(light)[LightPathAovFilm.LightPrefix.Length..];
            if (!lights.Contains(name))
            {
                throw new CommandException(ExitStatus.Usage, $"--light {word}: '{path}' has no light {Quotation.Of(light)}{Spelling.DidYouMean(light, lights)}, but {Names(lights)}");
            }

            if (!byLight.TryAdd(name, factor))
            {
                throw new CommandException(ExitStatus.Usage, $"--light {word}: the light {Quotation.Of(name)} is given twice");
            }
        }

        return byLight;
    }

    private static string Names(IReadOnlyList<string> lights) =>
        $"{string.Join(", ", lights.Take(MostNames))}{(lights.Count > MostNames ? $" and {lights.Count - MostNames} more" : "")}";
}
