using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Description;

/// <summary>Describes a shape.</summary>
public abstract record ShapeDescription
{
    /// <summary>The name that messages and editors use.</summary>
    [Parameter("A name for messages and editors; it need not be unique.")]
    public string Name { get; init; } = "";

    /// <summary>The layer of light that has what shines here.</summary>
    [Parameter("The layer for the light of what shines here when lights are written as layers (--aov lights). Without it: that of the "
        + "enclosing group, or else the name.")]
    public string LightGroup { get; init; } = "";

    /// <summary>The material of the shape; the same object as <see cref="DefaultMaterial"/> where none is given.</summary>
    [Parameter("The shape's material, or the name of one. Without it, that of the enclosing group.")]
    public MaterialDescription Material { get; init; } = DefaultMaterial;

    /// <summary>The transform of the shape from where its own numbers put it; empty for none.</summary>
    [Parameter("How the shape is moved from where its numbers put it: steps, the first one applied first.")]
    public IReadOnlyList<TransformDescription> Transform { get; init; } = [];

    /// <summary>The motion of the shape in time, after its transform; empty where it rests.</summary>
    [Parameter("How the shape moves in time, from where it is otherwise: keyframes in the order of their times. It is blurred by its "
        + "movement while the shutter is open.")]
    public IReadOnlyList<KeyframeDescription> Motion { get; init; } = [];

    /// <summary>As what editors offer to add the shape: unless it says otherwise, as a shape, and with a luminaire as a light.</summary>
    public virtual SketchKinds SketchedAs => SketchKinds.Shape | SketchKinds.Light;

    /// <summary>About where the middle is, in the shape's own space: the origin for what consists of others.</summary>
    public virtual Vector3 Middle => default;

    /// <summary>The material of shapes that give none: grey, matt.</summary>
    public static MaterialDescription DefaultMaterial { get; } = new Materials.DiffuseMaterialDescription();

    /// <summary>The shape as an editor adds it to a scene: seen at once.</summary>
    /// <param name="view">The place and the size.</param>
    public virtual ShapeDescription Sketch(SketchView view) => this with { Transform = [new() { Translate = view.At(default) }] };

    /// <summary>The same look at another place by other numbers; null where only a transform can move it there.</summary>
    /// <param name="move">The movement.</param>
    public virtual ShapeDescription? Moved(in ShapeMove move) => null;

    /// <summary>
    /// Makes the shape that this record describes, where its own numbers put it, or reports why it cannot be made and returns null.
    /// </summary>
    /// <param name="builder">Gives access to materials and takes diagnostics.</param>
    public abstract Shape? Build(SceneBuilder builder);
}

/// <summary>A map that an editor works into the numbers of a <see cref="ShapeDescription"/>.</summary>
/// <param name="Map">The map.</param>
/// <param name="ShowsUv">True where a texture shows how uv lies on the surface.</param>
public readonly record struct ShapeMove(Transform Map, bool ShowsUv)
{
    /// <summary>True where the axes keep their directions.</summary>
    public bool KeepsAxes => Map.KeepsAxes;

    /// <summary>The factor on all lengths; null where there is none, or where the uv of what is round would be turned.</summary>
    public float? RoundScale => ShowsUv && !KeepsAxes ? null : (float?)Map.UniformScale();

    /// <summary>True where the map mirrors.</summary>
    public bool Mirrors => Map.Determinant < 0;

    /// <summary>The image of a point.</summary>
    public Vector3 Point(Vector3 point) => Map.Point(point);

    /// <summary>The image of a difference of points.</summary>
    public Vector3 Vector(Vector3 vector) => Map.Vector(vector);

    /// <summary>The image of a direction of any length: its text stays unchanged if it still points there.</summary>
    public Vector3 Direction(Vector3 written) => Kept(written, Map.Vector(written).Unit());

    /// <summary>The image of a normal, of any length: its text stays unchanged if it still points there.</summary>
    public Vector3 Normal(Vector3 written) => Kept(written, Map.Inverse().TransposedVector(written).Unit());

    private static Vector3 Kept(Vector3 written, Vector3 moved) => (written.Unit() - moved).Norm() < 1e-6f ? written : moved;
}
