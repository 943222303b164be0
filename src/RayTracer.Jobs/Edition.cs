using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textbook;
using SceneReader = RayTracer.Textbook.SceneReader;

namespace RayTracer.Jobs;

/// <summary>
/// The edition of the renderer that makes a picture: the fast one, or <see cref="RayTracer.Textbook"/>, which is there to be read. Films of the latter say
/// so in their content, and go with no others.
/// </summary>
internal static class Edition
{
    private const string Textbook = "textbook";
    private const string SystemBits = ", whose bits depend on the system";
    private static readonly string[] s_own = [.. SceneReader.OwnIntegrators.Select(i => $"{Textbook}:{i}")];

    /// <summary>The words of the option; the fast edition is the first.</summary>
    public static IReadOnlyList<string> Words { get; } = ["fast", Textbook, .. s_own];

    /// <summary>The edition that a job of a scene asks for; null for the fast one. An integrator of a plug-in may be of the textbook edition alone.</summary>
    /// <param name="edition">The edition that the job names; null for none.</param>
    /// <param name="render">The settings of the scene.</param>
    public static string? For(string? edition, RenderDescription render) => edition ?? (render.Integrator is IOwnIntegrator ? Textbook : null);

    /// <summary>What is added to the name of the program in files, where their bits are not the same on every machine.</summary>
    /// <param name="edition">The edition; null for the fast one.</param>
    /// <param name="scene">The scene.</param>
    public static string Software(string? edition, SceneDescription scene) => edition is not null ? $", {edition} edition{SystemBits}"
        : RecordType.WithParts(scene).Any(r => r.Record is IOwnMaterial or IOwnShape) ? $", with classes of the textbook edition{SystemBits}" : "";

    /// <summary>The program that merges films, with what those say of their bits.</summary>
    public static string Software(IEnumerable<FilmHeader> parts) =>
        parts.FirstOrDefault(p => p.Software.EndsWith(SystemBits, StringComparison.Ordinal))?.Software ?? ProgramName.Text;

    /// <summary>The content of a film of an edition, by that of the fast one.</summary>
    public static string Content(string content, string? edition) => edition is null ? content : $"{edition}-{content}";

    /// <summary>The edition that a film was rendered by, by its content; null for the fast one.</summary>
    public static string? Of(string content) => Words.LastOrDefault(w => content.StartsWith($"{w}-", StringComparison.Ordinal));

    /// <summary>Why a film does not go with an edition; null where that is not the reason.</summary>
    /// <param name="content">The film's content.</param>
    /// <param name="edition">The edition that is asked for; null for the fast one.</param>
    public static string? Complaint(string content, string? edition)
    {
        string? own = Of(content);
        return own == edition ? null
            : own is null ? "the film was not rendered by the textbook edition: leave --edition out" : $"the film was rendered by another edition: give --edition {own}";
    }

    /// <summary>The textbook edition's renderer of a scene that has been loaded; null where the fast one renders it.</summary>
    /// <param name="edition">The edition; null for the fast one.</param>
    /// <param name="load">The scene.</param>
    /// <param name="refused">Takes what that edition lacks, at its places in the file.</param>
    public static Renderer? Renderer(string? edition, SceneLoadResult load, out IReadOnlyList<Diagnostic> refused)
    {
        refused = [];
        if (edition is null)
        {
            return null;
        }

        SceneReader reader = new(load.LoadPicture, load.LoadModel);
        Renderer? renderer = reader.Read(load.Description!, edition.Split(':') is [_, var own] ? own : null);
        refused = [.. reader.Complaints.Select(load.Locate)];
        return renderer;
    }
}
