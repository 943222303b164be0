using System.Numerics;
using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>The scene that the view shows, and how it is rendered.</summary>
/// <param name="Good">The document's content that it comes from.</param>
/// <param name="Scene">
/// The scene as it is rendered: with the camera as it is moved at the moment, and the samples that the user wants.
/// </param>
/// <param name="Camera">That camera.</param>
/// <param name="Settings">The user's settings.</param>
/// <param name="Picture">The picture's number: scenes with the same number continue its samples.</param>
/// <param name="Start">The film whose samples the picture begins with; null for none.</param>
public sealed record ViewportScene(
    GoodScene Good, Scene Scene, CameraDescription Camera, ViewSettings Settings, long Picture = 0, FilmStart? Start = null)
{
    /// <summary>The document that it is of: pictures of another have nothing to do with it.</summary>
    internal DocumentPlace? Place { get; init; }

    /// <summary>How often rendering was begun from scratch on request: earlier pictures are not wanted any more.</summary>
    internal int Round { get; init; }

    private readonly Dictionary<object, string?> _pointers = new(ReferenceEqualityComparer.Instance);
    private readonly Lazy<(Vector3, float)> _extent = new(() =>
    {
        Bounds all = new SceneStatistics(Scene).FiniteBounds;
        float size = ((all.Maximum - all.Minimum) * 0.5f).Norm();
        return all.IsFinite && size > 0 ? ((all.Minimum + all.Maximum) * 0.5f, size) : (Vector3.Zero, 1);
    });

    /// <summary>The description of what is seen of the scene.</summary>
    public SceneDescription Description => Good.Description;

    /// <summary>The first sample that pixels get: more than 0 where the picture goes on with a part of one.</summary>
    public int First => Start?.Held.First ?? 0;

    /// <summary>One more than the last sample that each pixel gets.</summary>
    public int Samples => First > 0 ? Start!.Header.Wanted.End : Scene.Render.SamplesPerPixel;

    /// <summary>The part to render.</summary>
    public Tile Area => Settings.Region ?? new(0, 0, Scene.Render.Width, Scene.Render.Height);

    /// <summary>Width of the picture over its height.</summary>
    public float Aspect => (float)Scene.Render.Width / Scene.Render.Height;

    /// <summary>Reads the scene into the textbook edition, where the user chose that; else null.</summary>
    /// <exception cref="SessionException">It lacks something that the scene has.</exception>
    internal Textbook.Renderer? ReadTextbook()
    {
        if (Edition.For(Settings.Edition, Scene.Render) is not { } edition || Good.Load is not { } load)
        {
            return null;
        }

        Textbook.Renderer? renderer = Edition.Renderer(edition, load with { Description = PictureView.Rendered(this) }, out IReadOnlyList<Diagnostic> refused);
        return renderer ?? throw new SessionException($"{refused[0]}; the fast edition renders it");
    }

    /// <summary>
    /// The middle of all that has an end, and half the diagonal of the box around it; the origin and 1 where there is nothing.
    /// </summary>
    public (Vector3 Middle, float Size) Extent => _extent.Value;

    /// <summary>The pointer to a record in the text; null where it is not from the text.</summary>
    public string? PointerOf(object? record)
    {
        if (record is null)
        {
            return null;
        }

        lock (_pointers)
        {
            if (!_pointers.TryGetValue(record, out string? pointer))
            {
                JsonNode? node = Good.Read.SourceMap.Find(record);
                pointer = node is null || Good.Read.Root is not { } root ? null : JsonPointer.To(root, node);
                _pointers.Add(record, pointer);
            }

            return pointer;
        }
    }

    /// <summary>The pointer of what a surface was made from; null for nothing.</summary>
    public string? PointerOf(SurfaceName surface) =>
        surface == SurfaceName.None ? null : PointerOf(Scene.SourceOf(surface.Primitive, surface.Instance));

    /// <summary>The pointer of a surface's material; null for nothing, and where the material is not from the text.</summary>
    public string? MaterialOf(SurfaceName surface) =>
        surface == SurfaceName.None ? null : PointerOf(Scene.MaterialSourceOf(surface.Primitive));
}
