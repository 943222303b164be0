using RayTracer.Description;

namespace RayTracer.Textbook;

/// <summary>Turns the description of a camera into one.</summary>
/// <param name="refusals">Takes what there is none of.</param>
internal sealed class CameraReader(Refusals refusals)
{
    /// <summary>Makes the camera; null where it is refused.</summary>
    /// <param name="camera">The description.</param>
    /// <param name="width">Width of the picture in pixels.</param>
    /// <param name="height">Height of the picture in pixels.</param>
    public ICamera? Read(CameraDescription camera, int width, int height)
    {
        refusals.Rest(
            camera, nameof(camera.Position), nameof(camera.LookAt), nameof(camera.Up), nameof(camera.Projection), nameof(camera.ViewSize), nameof(camera.FieldOfView),
            nameof(camera.FieldOfViewAxis), nameof(camera.Lens), nameof(camera.Transform));
        Transform place = ShapeReader.Place(camera.Transform);
        Vector forward = (Vector)camera.LookAt - camera.Position;
        double distance = forward.Length;
        forward = forward.Unit;
        Vector right = Vector.Cross(forward, camera.Up).Unit;
        Vector up = Vector.Cross(right, forward);
        if (Math.Abs(Math.Abs(place.Determinant) - 1) > 1e-5 || Math.Abs(place.X.Length - 1) > 1e-5 || Math.Abs(Vector.Dot(place.X, place.Y)) > 1e-5)
        {
            refusals.Say(camera, nameof(camera.Transform), "the textbook edition moves, turns and mirrors cameras, but does not scale them");
        }

        Vector eye = place.Point(camera.Position);
        (forward, right, up) = (place.Direction(forward), place.Direction(right), place.Direction(up));
        double extent = Extent(camera.FieldOfViewAxis, width, height);
        if (camera.Projection == Projection.Orthographic)
        {
            if (Lens(camera.Lens, right, up, place) is not Pinhole)
            {
                refusals.Say(camera.Lens, nameof(LensDescription.Shape), "the textbook edition has lenses of perspective cameras only");
            }

            return new OrthographicCamera(eye, forward, right, up, width, height, camera.ViewSize / extent);
        }

        if (camera.Projection != Projection.Perspective)
        {
            refusals.Say(camera, nameof(camera.Projection), $"the textbook edition has no {camera.Projection.Name} cameras: it has perspective and orthographic ones");
            return null;
        }

        double pixel = 2 * Math.Tan(camera.FieldOfView * Math.PI / 360) / extent;
        double focus = camera.Lens.FocusDistance > 0 ? camera.Lens.FocusDistance : distance;
        return new PerspectiveCamera(eye, forward, right, up, width, height, pixel, Lens(camera.Lens, right, up, place), focus);
    }

    private ILens Lens(LensDescription lens, Vector right, Vector up, Transform place)
    {
        (right, up) = (right * lens.ApertureRadius, up * lens.ApertureRadius);
        return lens.Shape switch
        {
            LensShape.EyeJitter => lens.Jitter == default ? new Pinhole() : new EyeJitter(place.After(Transform.Scaling(lens.Jitter))),
            _ when lens.ApertureRadius == 0 => new Pinhole(),
            LensShape.Disk => new RoundLens(right, up),
            LensShape.Square => new SquareLens(right, up),
            _ => (ILens?)refusals.Say(lens, nameof(lens.Shape), "the textbook edition has no bladed lenses: it has round and square ones, and the report's jitter of the eye") ?? new Pinhole(),
        };
    }

    private static double Extent(FieldOfViewAxis axis, double width, double height) => axis switch
    {
        FieldOfViewAxis.Vertical => height,
        FieldOfViewAxis.Horizontal => width,
        FieldOfViewAxis.Smaller => Math.Min(width, height),
        FieldOfViewAxis.Larger => Math.Max(width, height),
        _ => Math.Sqrt((width * width) + (height * height)),
    };
}
