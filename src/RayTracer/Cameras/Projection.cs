using RayTracer.Cameras;

namespace RayTracer.Description;

/// <summary>The projection of the scene to the picture: what holds for all cameras that have it.</summary>
/// <param name="name">The name in scene files, in camelCase.</param>
public abstract class Projection(string name) : NamedValue(name)
{
    /// <summary>By rays through one point: what is farther away is smaller.</summary>
    public static Projection Perspective { get; } = new PerspectiveKind();

    /// <summary>By parallel rays: nothing gets smaller with distance.</summary>
    public static Projection Orthographic { get; } = new OrthographicKind();

    /// <summary>All directions around one point: longitude across the picture, latitude along its height (equirectangular).</summary>
    public static Projection Spherical { get; } = new SphericalKind();

    /// <summary>All projections.</summary>
    public static Registry<Projection> Known { get; } = new("projection", p => [p.Name], Perspective, Orthographic, Spherical);

    /// <summary>The reason why a camera of this kind cannot have a lens, as the end of a message; null where it can.</summary>
    public virtual string? LensComplaint => null;

    /// <summary>
    /// The reason why a camera of this kind cannot show a window of its picture, as the end of a message; null where it can.
    /// </summary>
    public virtual string? WindowComplaint => null;

    /// <summary>True where straight lines are straight in the picture.</summary>
    public virtual bool IsStraight => true;

    /// <summary>True where all rays are parallel, so that nothing gets smaller with distance.</summary>
    public virtual bool IsParallel => false;

    /// <summary>Returns the height of the part of a plane across the view that fills a picture from its lower to its upper edge.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="distance">The distance of the plane.</param>
    /// <param name="aspect">Width of the picture over its height.</param>
    public abstract float HeightAt(CameraDescription camera, float distance, float aspect);

    /// <summary>The camera that shows a factor more, from the same place; null where the kind always shows the same.</summary>
    public abstract CameraDescription? Zoomed(CameraDescription camera, float factor);

    /// <summary>By how many degrees the view turns while a thing moves over the height of the picture.</summary>
    public virtual float DegreesOfHeight(CameraDescription camera) => camera.FieldOfView;

    /// <summary>Makes what maps points of a camera's picture to rays.</summary>
    public abstract CameraProjection Create(in CameraView view);
}
