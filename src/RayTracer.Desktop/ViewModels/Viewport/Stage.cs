using System.Numerics;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The place of the picture on the part of the window that it is shown in.</summary>
/// <param name="PictureWidth">Pixels of the picture across.</param>
/// <param name="PictureHeight">Pixels of the picture down.</param>
/// <param name="Width">The part's width, in the window's pixels.</param>
/// <param name="Height">The part's height.</param>
/// <param name="Zoom">The window's pixels for each pixel of the picture; null for as large as fits.</param>
/// <param name="Shift">The distance of the picture's middle from the part's.</param>
internal sealed record Stage(int PictureWidth, int PictureHeight, double Width, double Height, double? Zoom, Spot Shift)
{
    private const double Margin = 12;
    private const double SmallestZoom = 0.05;
    private const double LargestZoom = 64;

    /// <summary>One without a picture.</summary>
    public static Stage Empty { get; } = new(0, 0, 1, 1, null, default);

    /// <summary>The window's pixels for each pixel of the picture.</summary>
    public double Scale => Zoom ?? Math.Max(0.01, Math.Min((Width - (2 * Margin)) / Math.Max(1, PictureWidth), (Height - (2 * Margin)) / Math.Max(1, PictureHeight)));

    /// <summary>The picture's place.</summary>
    public Box Place => new(
        Math.Round(((Width - (PictureWidth * Scale)) / 2) + (Zoom is null ? 0 : Shift.X)), Math.Round(((Height - (PictureHeight * Scale)) / 2) + (Zoom is null ? 0 : Shift.Y)),
        PictureWidth * Scale, PictureHeight * Scale);

    /// <summary>The point of the picture under a point of the part.</summary>
    public Spot ToPicture(Spot point) => new((point.X - Place.Left) / Scale, (point.Y - Place.Top) / Scale);

    /// <summary>The point of the part over a point of the picture.</summary>
    public Spot ToScreen(Spot point) => new(Place.Left + (point.X * Scale), Place.Top + (point.Y * Scale));

    /// <summary>The place of some of the picture's pixels.</summary>
    public Box ToScreen(Rendering.Tile pixels) =>
        new(Place.Left + (pixels.X * Scale), Place.Top + (pixels.Y * Scale), pixels.Width * Scale, pixels.Height * Scale);

    /// <summary>The pixel under a point of the part; null beside the picture.</summary>
    public Spot? PixelAt(Spot point)
    {
        (double x, double y) = ToPicture(point);
        (x, y) = (Math.Floor(x), Math.Floor(y));
        return x >= 0 && y >= 0 && x < PictureWidth && y < PictureHeight ? new(x, y) : null;
    }

    /// <summary>The whole pixels between two points of the picture; null where there are too few.</summary>
    public Rendering.Tile? Between(Spot a, Spot b)
    {
        int left = (int)Math.Max(0, Math.Floor(Math.Min(a.X, b.X)));
        int top = (int)Math.Max(0, Math.Floor(Math.Min(a.Y, b.Y)));
        int right = (int)Math.Min(PictureWidth, Math.Ceiling(Math.Max(a.X, b.X)));
        int bottom = (int)Math.Min(PictureHeight, Math.Ceiling(Math.Max(a.Y, b.Y)));
        return right - left > 1 && bottom - top > 1 ? new(left, top, right - left, bottom - top) : null;
    }

    /// <summary>Enlarged by a factor; the point of the picture under another one stays where it is.</summary>
    public Stage ZoomedBy(double factor, Spot around)
    {
        double scale = Math.Clamp(Scale * factor, SmallestZoom, LargestZoom);
        double real = scale / Scale;
        (double x, double y) = (Place.Left + (Place.Width / 2), Place.Top + (Place.Height / 2));
        return this with { Zoom = scale, Shift = new(around.X + ((x - around.X) * real) - (Width / 2), around.Y + ((y - around.Y) * real) - (Height / 2)) };
    }

    /// <summary>Enlarged by a factor about the middle.</summary>
    public Stage ZoomedBy(double factor) => ZoomedBy(factor, new(Width / 2, Height / 2));

    /// <summary>Moved on the screen.</summary>
    public Stage ShiftedBy(double dx, double dy) =>
        this with { Zoom = Scale, Shift = new(Zoom is null ? dx : Shift.X + dx, Zoom is null ? dy : Shift.Y + dy) };
}

/// <summary>A rectangle on the screen.</summary>
internal sealed record Box(double Left, double Top, double Width, double Height)
{
    /// <summary>One that is not to be seen.</summary>
    public static Box None { get; } = new(0, 0, 0, 0);

    public bool IsVisible => Width > 0 && Height > 0;
}

/// <summary>A point of the screen or of the picture, in pixels.</summary>
internal readonly record struct Spot(double X, double Y)
{
    public double DistanceTo(Spot other) => Math.Sqrt(((X - other.X) * (X - other.X)) + ((Y - other.Y) * (Y - other.Y)));

    /// <summary>As a vector.</summary>
    public Vector2 AsVector() => new((float)X, (float)Y);
}
