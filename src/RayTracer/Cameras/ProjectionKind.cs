using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>A way of mapping what a camera sees to the picture: what holds for all cameras that map by it.</summary>
public abstract class ProjectionKind
{
    private static readonly ProjectionKind Perspective = new PerspectiveKind();
    private static readonly ProjectionKind Orthographic = new OrthographicKind();
    private static readonly ProjectionKind Spherical = new SphericalKind();

    /// <summary>Why a camera of this kind cannot have a lens, as the end of a message; null where it can.</summary>
    public virtual string? LensComplaint => null;

    /// <summary>Why a camera of this kind cannot show a window of its picture, as the end of a message; null where it can.</summary>
    public virtual string? WindowComplaint => null;

    /// <summary>True where straight lines are straight in the picture.</summary>
    public virtual bool IsStraight => true;

    /// <summary>True where all rays are parallel, so that nothing gets smaller with distance.</summary>
    public virtual bool IsParallel => false;

    /// <summary>The kind of a camera's projection.</summary>
    public static ProjectionKind Of(CameraDescription camera) => camera.Projection switch
    {
        Projection.Orthographic => Orthographic,
        Projection.Spherical => Spherical,
        _ => Perspective,
    };

    /// <summary>How much of a plane across the view a picture shows from its lower to its upper edge.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="distance">How far away the plane is.</param>
    /// <param name="aspect">Width of the picture over its height.</param>
    public abstract float HeightAt(CameraDescription camera, float distance, float aspect);

    /// <summary>The camera that shows a factor more, from the same place; null where the kind always shows the same.</summary>
    public abstract CameraDescription? Zoomed(CameraDescription camera, float factor);

    /// <summary>By how many degrees the view turns while a thing moves over the height of the picture.</summary>
    public virtual float DegreesOfHeight(CameraDescription camera) => camera.FieldOfView;

    /// <summary>The projection of a camera.</summary>
    internal abstract CameraProjection Create(in CameraView view);
}

/// <summary>A camera and its picture.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Forward">Unit viewing direction.</param>
/// <param name="Right">Unit direction to the right in the picture.</param>
/// <param name="Up">Unit direction upwards in the picture.</param>
/// <param name="Width">Width of the picture in pixels.</param>
/// <param name="Height">Height of the picture in pixels.</param>
internal readonly record struct CameraView(CameraDescription Camera, Vector3 Forward, Vector3 Right, Vector3 Up, int Width, int Height)
{
    /// <summary>The distance of the plane in focus.</summary>
    public float Focus => Camera.Lens.FocusDistance > 0 ? Camera.Lens.FocusDistance : (Camera.LookAt - Camera.Position).Dot(Forward);

    /// <summary>The upper left corner of the picture on a plane across the view, and the steps from pixel to pixel there.</summary>
    /// <param name="middle">The point of the plane in the viewing direction.</param>
    /// <param name="shown">How much of the plane is shown by the extent of the whole picture that the field of view measures.</param>
    public (Vector3 Corner, Vector3 StepX, Vector3 StepY) OnPlane(Vector3 middle, float shown)
    {
        (float width, float height, float middleX, float middleY) = Whole;
        float pixel = shown / ViewPlane.Extent(Camera.FieldOfViewAxis, width, height);
        (Vector3 stepX, Vector3 stepY) = (Right * pixel, Up * -pixel);
        return (middle - stepX * middleX - stepY * middleY, stepX, stepY);
    }

    // The size of the whole of which a window is seen, in the pixels of the window, and where its middle is from the window's upper left corner.
    private (float Width, float Height, float MiddleX, float MiddleY) Whole
    {
        get
        {
            if (Camera.Window is not [var x, var y, var width, var height])
            {
                return (Width, Height, 0.5f * Width, 0.5f * Height);
            }

            (float wholeWidth, float wholeHeight) = (Width / width, Height / height);
            return (wholeWidth, wholeHeight, (0.5f - x) * wholeWidth, (0.5f - y) * wholeHeight);
        }
    }
}
