using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Reads a scene file, native or of another <see cref="SceneFormat"/>, or a model file as a scene by itself, and builds the scene that it describes. Bad content never throws: it becomes diagnostics.</summary>
public static class SceneLoader
{
    /// <summary>Loads a scene, or a model, which gets a camera and light where it has none.</summary>
    /// <param name="path">The file's path, by which diagnostics call it too; pictures are looked for from its folder.</param>
    /// <param name="overrides">Changes the description before the scene is built, as options of a command line do.</param>
    /// <param name="readPicture">
    /// Reads the picture file of a path, decoded from sRGB unless the second argument says that its numbers are to be
    /// taken raw; may throw <see cref="PictureException"/>. By default <see cref="ImageFile.Read"/>.
    /// </param>
    /// <param name="settings">Values to put in the place of the file's before it is checked; those of a file in another format go by what the scene is in the native one.</param>
    /// <param name="frame">The frame of the animation; null for the scene as it is written.</param>
    public static SceneLoadResult Load(
        string path, Func<SceneDescription, SceneDescription>? overrides = null, Func<string, bool, Picture>? readPicture = null, IReadOnlyList<SceneSetting>? settings = null,
        int? frame = null) => Read(path, settings, frame).Build(overrides, readPicture);

    /// <summary>Reads a scene, which is then built without reading its file again.</summary>
    /// <param name="path">As for <see cref="Load"/>.</param>
    /// <param name="settings">As for <see cref="Load"/>.</param>
    /// <param name="frame">As for <see cref="Load"/>.</param>
    public static ReadScene Read(string path, IReadOnlyList<SceneSetting>? settings = null, int? frame = null)
    {
        string folder = Path.GetDirectoryName(path) ?? "";
        ModelFolder models = new(folder);
        SceneBudget budget = new();
        using IDisposable counted = budget.Begin();
        if (SceneFormat.Foreign(path) is { } foreign)
        {
            return new(SceneReader.Unreadable(path, foreign), folder, models, frame, budget);
        }

        if (ImageFile.FormatOf(path) is { } format)
        {
            string advice = format is FilmFormat
                ? $"\"raytracer resume {path}\" resumes it, \"raytracer convert {path} FILE.png\" makes an image of it"
                : $"\"raytracer view {path}\" shows it";
            string message = $"this is {format.FileName}, not a scene: {advice}";
            return new(SceneReader.Unreadable(path, message), folder, models, frame, budget);
        }

        SceneReadResult read = ModelFile.IsModel(path) ? Set(ModelScene.Read(path, models, settings), settings)
            : SceneFormat.Of(path) is { } other ? Set(other.Read(path), settings) : SceneReader.Read(path, settings, frame);
        return new(read, folder, models, frame, budget);
    }

    /// <summary>Builds the scene of a text in the native format.</summary>
    /// <param name="text">The text.</param>
    /// <param name="fileName">The name of the file in diagnostics.</param>
    /// <param name="folder">The folder from which files that it names are looked for.</param>
    /// <param name="overrides">As for <see cref="Load"/>.</param>
    /// <param name="frame">As for <see cref="Load"/>.</param>
    /// <param name="readPicture">As for <see cref="Load"/>.</param>
    /// <param name="settings">As for <see cref="Load"/>.</param>
    public static SceneLoadResult LoadText(
        string text, string fileName, string folder, Func<SceneDescription, SceneDescription>? overrides = null, int? frame = null, Func<string, bool, Picture>? readPicture = null,
        IReadOnlyList<SceneSetting>? settings = null) =>
        ReadText(text, fileName, folder, settings, frame).Build(overrides, readPicture);

    /// <summary>As <see cref="Read"/>, of a text in the native format.</summary>
    public static ReadScene ReadText(string text, string fileName, string folder, IReadOnlyList<SceneSetting>? settings = null, int? frame = null) =>
        new(SceneReader.ReadText(text, fileName, settings, frame), folder, new ModelFolder(folder), frame, new());

    private static SceneReadResult Set(SceneReadResult read, IReadOnlyList<SceneSetting>? settings)
    {
        if (settings is not { Count: > 0 } || read.Description is not { } scene)
        {
            return read;
        }

        if (settings.All(s => s.Path.StartsWith("render.", StringComparison.Ordinal)))
        {
            return SetRender(read, scene, settings);
        }

        SceneReadResult native = SceneReader.ReadText(SceneWriter.Write(scene), $"{FileName(read)}, converted", settings);
        return new(native.Source, native.Root, native.Partial, native.SourceMap, read.Diagnostics.Concat(native.Diagnostics));
    }

    // Everything else is not converted, and keeps its places in the file.
    private static SceneReadResult SetRender(SceneReadResult read, SceneDescription scene, IReadOnlyList<SceneSetting> settings)
    {
        string text = SceneWriter.Write(new() { Camera = scene.Camera, Render = scene.Render });
        SceneReadResult native = SceneReader.ReadText(text, $"{FileName(read)}, converted", settings);
        SceneDescription changed = scene with { Render = native.Partial?.Render ?? scene.Render };
        read.SourceMap.Follow(scene, changed);
        return new(read.Source, read.Root, changed, read.SourceMap, read.Diagnostics.Concat(native.Diagnostics));
    }

    /// <summary>Builds the scene of a description that has been read; it remembers the records that its parts were made from.</summary>
    /// <param name="read">The scene as it was read.</param>
    /// <param name="folder">The folder from which pictures are looked for.</param>
    /// <param name="overrides">As for <see cref="Load"/>.</param>
    /// <param name="readPicture">As for <see cref="Load"/>.</param>
    /// <param name="readModel">Reads the model file of a path; may throw <see cref="ModelException"/>. By default <see cref="ModelFile.Read"/>.</param>
    public static SceneLoadResult Build(
        SceneReadResult read, string folder, Func<SceneDescription, SceneDescription>? overrides = null, Func<string, bool, Picture>? readPicture = null,
        Func<string, ImportedModel>? readModel = null) =>
        Build(read, folder, new ModelFolder(folder, readModel), overrides, readPicture, keepsSources: true);

    internal static SceneLoadResult Build(
        SceneReadResult read, string folder, ModelFolder models, Func<SceneDescription, SceneDescription>? overrides, Func<string, bool, Picture>? readPicture,
        bool keepsSources)
    {
        if (read.Partial is not { } description)
        {
            return new(null, null, read.Diagnostics);
        }

        List<Diagnostic> diagnostics = [.. read.Diagnostics];
        if (overrides is not null)
        {
            description = Override(description, overrides, read);
        }

        Scene? scene = null;
        IReadOnlyDictionary<(string File, string Animation), double> played = new Dictionary<(string, string), double>();
        RecordOwners owners = new(description);
        Func<string, bool, Picture> Pictures(SceneBudget budget) => new PictureFolder(folder, readPicture ?? ImageFile.Read, budget).Load;
        if (!diagnostics.Exists(d => d is { Line: 0, Column: 0 } && d.Severity == Severity.Error))
        {
            SceneBudget budget = SceneBudget.Open ?? new();
            using IDisposable counted = budget.Begin();
            SceneBuilder builder = new(Pictures(budget), models.Load, new VolumeFolder(folder).Load) { KeepsSources = keepsSources, Budget = budget };
            scene = builder.Build(description);
            played = builder.Played;
            if (scene is not null && read.Description is not null)
            {
                // Of a scene with errors it is not known.
                new UnseenParts(scene, description, builder).WarnOfDarkness();
            }

            diagnostics.AddRange(builder.Complaints.Where(c => !read.SourceMap.IsIncomplete(c.Subject)).Select(c => ToDiagnostic(c, read, owners)));
        }

        bool isGood = !diagnostics.Exists(d => d.Severity == Severity.Error);
        return new(isGood ? scene : null, read.Description is null ? null : description, Diagnostic.Sort(diagnostics))
        {
            Played = played,
            LoadPicture = Pictures(new()),
            LoadModel = models.Load,
            Locate = complaint => ToDiagnostic(complaint, read, owners),
        };
    }

    private static SceneDescription Override(SceneDescription original, Func<SceneDescription, SceneDescription> overrides, SceneReadResult read)
    {
        SceneDescription changed = overrides(original);
        (object From, object To)[] parts =
            [(original, changed), (original.Render, changed.Render), (original.Camera, changed.Camera), (original.Camera.Lens, changed.Camera.Lens)];
        Array.ForEach(parts, p => read.SourceMap.Follow(p.From, p.To));
        return changed;
    }

    private static Diagnostic ToDiagnostic(SceneComplaint complaint, SceneReadResult read, RecordOwners owners)
    {
        Severity severity = complaint.IsError ? Severity.Error : Severity.Warning;
        Diagnostic diagnostic = read.SourceMap.Find(complaint.Subject, complaint.Property) is { } node ? read.Source!.At(node.Start, severity, complaint.Message)
            : owners.From(complaint.Subject).Select(read.SourceMap.PlaceOf).FirstOrDefault(p => p is not null) is { } place ? place.At(severity, complaint.Message)
            : new(FileName(read), 0, 0, severity, complaint.Message);
        return complaint.IsOutOfRange ? diagnostic with { Rule = DiagnosticRule.OutOfRange } : diagnostic;
    }

    private static string FileName(SceneReadResult read) => read.Source!.FileName;
}

/// <summary>The result of loading a scene file.</summary>
/// <param name="Scene">The scene, ready to be rendered; null where any diagnostic is an error.</param>
/// <param name="Description">The scene's description; null where any diagnostic of reading it is an error.</param>
/// <param name="Diagnostics">The faults, by position.</param>
public sealed record SceneLoadResult(Scene? Scene, SceneDescription? Description, IReadOnlyList<Diagnostic> Diagnostics)
{
    // The seconds of the animations of models that are played, by the file and the animation's name in the scene.
    internal IReadOnlyDictionary<(string File, string Animation), double> Played { get; init; } = new Dictionary<(string, string), double>();

    /// <summary>Reads the picture files that the scene names, for others who make something of its description; raw where the second argument says so.</summary>
    public Func<string, bool, Picture> LoadPicture { get; init; } = (_, _) => throw new PictureException("the scene was not read");

    /// <summary>Reads the model files that the scene names.</summary>
    public Func<string, ImportedModel> LoadModel { get; init; } = _ => throw new ModelException("the scene was not read");

    /// <summary>Finds the place in the file of what is complained about.</summary>
    public Func<SceneComplaint, Diagnostic> Locate { get; init; } = c => new("", 0, 0, c.IsError ? Severity.Error : Severity.Warning, c.Message);
}

/// <summary>A format of scene files other than the native one; RayTracer.Import registers those of Mitsuba and pbrt.</summary>
/// <param name="Extension">The extension, with its dot; upper and lower case are the same.</param>
/// <param name="Read">Reads the file of a path, by which diagnostics call it too.</param>
public sealed record SceneFormat(string Extension, Func<string, SceneReadResult> Read)
{
    private static readonly Dictionary<string, SceneFormat> Formats = new(StringComparer.OrdinalIgnoreCase);

    // What people have of other programs, which would else be taken for damaged JSON.
    private static readonly (string Program, string[] Extensions)[] Others =
    [
        ("pbrt", [".pbrt"]), ("USD", [".usd", ".usda", ".usdc", ".usdz"]), ("Blender", [".blend"]), ("FBX", [".fbx"]), ("POV-Ray", [".pov"]),
        ("Collada", [".dae"]), ("3ds Max", [".3ds", ".max"]), ("Alembic", [".abc"]), ("Maya", [".ma", ".mb"]), ("STEP", [".step", ".stp"]),
    ];

    /// <summary>Adds a format, before the first scene is read.</summary>
    public static void Register(SceneFormat format) => Formats[format.Extension] = format;

    /// <summary>The complaint about a file of another program, with the formats that are read; null for any other file.</summary>
    internal static string? Foreign(string path)
    {
        string extension = Path.GetExtension(path).ToLowerInvariant();
        return Formats.ContainsKey(extension) || ModelFile.IsModel(path) || Others.FirstOrDefault(o => o.Extensions.Contains(extension)).Program is not { } program
            ? null
            : $"files of {program} are not read: scenes are {string.Join(", ", Formats.Keys.Prepend(".json"))}, and models {string.Join(", ", ModelFile.Extensions)}";
    }

    /// <summary>The format of a path; null where that is the native one, or a model's.</summary>
    public static SceneFormat? Of(string path) => Formats.Values.FirstOrDefault(f => path.EndsWith(f.Extension, StringComparison.OrdinalIgnoreCase));
}
