using System.CommandLine;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer denoise IMAGE -o FILE</c>: takes noise out of a picture or film that is there already.</summary>
internal sealed class DenoiseVerb
{
    private readonly Argument<string> _image = new("IMAGE")
    {
        Description = "A film that keeps two halves of its samples (render --halves); its scene is read too, for what the camera "
            + "rays meet. Or an OpenEXR file, whose layers albedo and normal are used (render --aov albedo,normal), or any other image: "
            + "its noise is estimated from its pixels alone, which is worse.",
    };

    private readonly Option<string?> _albedo = new("--albedo") { Description = "An image of the surfaces' colours. Default: the layer, if there is one.", HelpName = "FILE" };
    private readonly Option<string?> _normal = new("--normal") { Description = "An image of the normals. Default: the layer, if there is one.", HelpName = "FILE" };
    private readonly Option<string?> _scene = new("--scene")
    {
        Description = "The scene file of a film, where it is no longer where it was.",
        HelpName = "SCENE",
    };

    private readonly ParsedOption<long?> _threads = OptionValues.Integer("--threads", "The number of threads. Default: one for each core.", 1, 1024);
    private readonly WritingOptions _writing;
    private readonly VerboseOption _verbose;

    private DenoiseVerb(Command command)
    {
        command.Arguments.Add(_image);
        _writing = new(command, $"The image file: {ImageFormat.Endings()}. Repeatable.");
        command.AddOptions([_albedo, _normal, _scene, _threads, .. _writing.Looks, _writing.Transparent]);
        _verbose = new(command);
    }

    public static void Build(Command command, Streams streams)
    {
        DenoiseVerb verb = new(command);
        command.SetAction(result => verb.Run(result, streams));
    }

    private int Run(ParseResult result, Streams streams)
    {
        string path = result.GetValue(_image)!;
        IReadOnlyList<string> outputs = _writing.Files(result, new(), "", JobFiles.Check);
        ImageWriteOptions writing = _writing.Writing(result) with { Metadata = PictureTexts.Of(CommandLine.Text(result)) };
        _writing.WarnOfUnused(result, outputs, streams);
        StageTimes stages = _verbose.Times(result, streams);
        HeldFilm? film = CarriedFilm.Is(path) && CarriedFilm.Read(path) is var (header, held) ? new(header, held, path) : null;
        bool isOfFilm = film is not null && (film.Film.Planes.Contains(FilmPlane.Half) || !HasGuides(result, path));
        CheckAlpha(writing, isOfFilm ? film : null, path);
        Picture? denoised = isOfFilm ? OfFilm(film!, result, stages, streams) : OfImage(path, result, stages, streams);
        stages.End(JobStage.Denoise);
        if (denoised is null)
        {
            return SceneFile.FailureStatus(path);
        }

        writing = film is null ? writing.OfImage(path, ImageFile.ReadText(path)) : writing.With(film.Header.Tone);
        IImageRows image = denoised;
        (image, writing) = film is null ? (image, writing) : TransparentRows.Of(image, film.Film, writing);
        int written = JobFiles.Write(outputs, image, writing, streams).Count;
        stages.End(JobStage.Write);
        return written < outputs.Count ? ExitStatus.InputOutput : ExitStatus.Fine;
    }

    private static void CheckAlpha(ImageWriteOptions writing, HeldFilm? film, string path)
    {
        if (film is not null)
        {
            PictureFiles.CheckAlpha(writing, film.Film.Planes, path);
        }
        else if (writing.Transparent)
        {
            throw new CommandException(
                ExitStatus.Usage, $"--transparent is for films: which light of the image '{path}' is from behind everything is not known");
        }
    }

    private bool HasGuides(ParseResult result, string path) => result.GetValue(_albedo) is not null || result.GetValue(_normal) is not null
        || (FilmExr.IsNamed(path) && FilmExr.OtherLayers(path).Any(l => l is "albedo" or "normal"));

    private Picture? OfFilm(HeldFilm film, ParseResult result, StageTimes stages, Streams streams)
    {
        if (result.GetValue(_albedo) is not null || result.GetValue(_normal) is not null)
        {
            throw new CommandException(
                ExitStatus.Usage, "--albedo and --normal are for images: what the camera rays of a film meet is found in its scene: leave them out");
        }

        HeldFilm.CheckPicture(film.Header, film.Path);
        if (Denoising.Of(film, result.GetValue(_scene), Threads(result), new ConsoleRun(new(Quiet: true), streams)) is not { } denoising)
        {
            return null;
        }

        stages.End(JobStage.Load);
        if (film.Film.Planes.Contains(FilmPlane.Half))
        {
            return denoising.Denoise(film.Film, null)?.Picture ?? throw new CommandException(
                ExitStatus.InputOutput,
                $"all samples of '{film.Path}' ({film.Header.SamplesText}) are of one of the two halves that are compared: "
                + "merge it with others, or resume it");
        }

        streams.Warn($"'{film.Path}' does not keep two halves of its samples (render --halves), so that its noise is estimated from its pixels "
            + "alone, which is worse");
        return denoising.DenoiseWhole(film.Film);
    }

    private Picture OfImage(string path, ParseResult result, StageTimes stages, Streams streams)
    {
        if (result.GetValue(_scene) is not null)
        {
            throw new CommandException(
                ExitStatus.Usage, $"--scene is for films: '{path}' is an image, whose guides are layers, --albedo and --normal");
        }

        (Picture image, _, IReadOnlyList<ExrLayerChannel> layers) = ImageFile.ReadAll(path);
        Picture? albedo = Guide(path, image, layers, result.GetValue(_albedo), ["albedo.R", "albedo.G", "albedo.B"], isColor: true);
        Picture? normal = Guide(path, image, layers, result.GetValue(_normal), ["normal.X", "normal.Y", "normal.Z"], isColor: false);
        if (albedo is null && normal is null)
        {
            streams.Warn($"nothing is known of the surfaces in '{path}', so that their details are lost with the noise: give --albedo FILE and --normal FILE, "
                + "or an .exr image of render --aov albedo,normal");
        }

        stages.End(JobStage.Load);
        return Denoiser.Denoise(image, albedo, normal, Threads(result));
    }

    private int Threads(ParseResult result) => (int)(_threads.Value(result) ?? 0);

    private static Picture? Guide(string path, Picture image, IReadOnlyList<ExrLayerChannel> layers, string? file, string[] channels, bool isColor)
    {
        Picture? guide = file is null ? Layer(image, layers, channels) : isColor ? ImageFile.Read(file) : Normals(file);
        return guide is null || (guide.Width, guide.Height) == (image.Width, image.Height) ? guide : throw new CommandException(
            ExitStatus.Usage, $"'{file}' has {guide.Width}×{guide.Height} pixels, but '{path}' {image.Width}×{image.Height}");
    }

    private static Picture? Layer(Picture image, IReadOnlyList<ExrLayerChannel> layers, string[] channels)
    {
        ExrLayerChannel?[] found = [.. channels.Select(c => layers.FirstOrDefault(l => l.Name == c))];
        if (found.Contains(null))
        {
            return null;
        }

        Picture layer = new(image.Width, image.Height);
        double[] row = new double[image.Width];
        for (int y = 0; y < image.Height; y++)
        {
            for (int channel = 0; channel < channels.Length; channel++)
            {
                found[channel]!.ReadRow(y, row);
                for (int x = 0; x < row.Length; x++)
                {
                    layer.Pixels[(3 * ((y * image.Width) + x)) + channel] = (float)row[x];
                }
            }
        }

        return layer;
    }

    // Pictures to look at have coordinates from -1 to 1 as 0 to 1.
    private static Picture Normals(string file)
    {
        Picture normals = ImageFile.Read(file, raw: true);
        return ImageFile.FormatOf(file) is { } format && format.Features.HasFlag(ImageFeatures.Display)
            ? new(normals.Width, normals.Height, [.. normals.Pixels.Select(v => (2 * v) - 1)]) : normals;
    }
}
