namespace RayTracer.RenderTests.Oracle;

/// <summary>A view window in the plane that is in focus, seen through a lens (report, sections 3.2, 3.4 and 6.2.3).</summary>
internal sealed class Camera
{
    public required Vec Position { get; init; }

    public required Vec LookAt { get; init; }

    public required Vec Up { get; init; }

    /// <summary>Full angle, in degrees.</summary>
    public required double FieldOfView { get; init; }

    /// <summary>"vertical", "horizontal", "smaller" or "larger".</summary>
    public required string Axis { get; init; }

    /// <summary>"disk", "square" or "eyeJitter".</summary>
    public required string LensShape { get; init; }

    public required double ApertureRadius { get; init; }

    /// <summary>Zero is the distance to the point looked at.</summary>
    public required double FocusDistance { get; init; }

    public required Vec Jitter { get; init; }

    /// <summary>A ray through a point of the picture, in pixels from its upper left corner.</summary>
    public (Vec Origin, Vec Direction) Ray(double x, double y, int width, int height, RandomNumbers random)
    {
        Vec forward = (LookAt - Position).Unit;
        Vec right = Vec.Cross(forward, Up).Unit;
        Vec up = Vec.Cross(right, forward);
        double focus = FocusDistance > 0 ? FocusDistance : (LookAt - Position).Length;
        int measured = Axis switch
        {
            "vertical" => height,
            "horizontal" => width,
            "smaller" => Math.Min(width, height),
            "larger" => Math.Max(width, height),
            _ => throw new FormatException(Axis),
        };
        double pixel = 2 * focus * Math.Tan(FieldOfView * Math.PI / 360) / measured;
        Vec target = Position + (focus * forward) + (pixel * (x - (0.5 * width)) * right) - (pixel * (y - (0.5 * height)) * up);
        Vec origin = Position + LensPoint(right, up, random);
        return (origin, (target - origin).Unit);
    }

    private Vec LensPoint(Vec right, Vec up, RandomNumbers random)
    {
        switch (LensShape)
        {
            case "disk":
                Vec d = random.Around(0);
                return ApertureRadius * Math.Sqrt(random.Next()) * ((d.X * right) + (d.Y * up));
            case "square":
                return 2 * ApertureRadius * ((random.Centred() * right) + (random.Centred() * up));
            case "eyeJitter":
                return Jitter * new Vec(random.Centred(), random.Centred(), random.Centred());
            default:
                throw new FormatException(LensShape);
        }
    }
}
