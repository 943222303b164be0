using System.Numerics;

namespace RayTracer.Session;

/// <summary>
/// The numbers of a picture that is filtered, a plane for each, so that a register holds neighbours. To the left and right of each row there is room for the
/// reach of the filter; what lies there belongs to no thing.
/// </summary>
internal sealed class MovingPlanes
{
    /// <summary>Columns beside each row.</summary>
    public const int Margin = 16;

    private readonly float[] _light;

    /// <summary>Makes room.</summary>
    public MovingPlanes(int width, int height)
    {
        (Width, Height, Stride) = (width, height, width + (2 * Margin));
        Size = (Stride * height) + Vector<float>.Count;
        _light = new float[4 * Size];
    }

    /// <summary>Width in pixels.</summary>
    public int Width { get; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; }

    /// <summary>From a row to the next.</summary>
    public int Stride { get; }

    /// <summary>The numbers of a plane.</summary>
    public int Size { get; }

    /// <summary>All planes: red, green, blue, and the variance of the luminance.</summary>
    public float[] All => _light;

    /// <summary>Red.</summary>
    public Span<float> Red => _light.AsSpan(0, Size);

    /// <summary>Green.</summary>
    public Span<float> Green => _light.AsSpan(Size, Size);

    /// <summary>Blue.</summary>
    public Span<float> Blue => _light.AsSpan(2 * Size, Size);

    /// <summary>The variance of the luminance.</summary>
    public Span<float> Variance => _light.AsSpan(3 * Size, Size);

    /// <summary>The place of a pixel.</summary>
    public int At(int x, int y) => (y * Stride) + Margin + x;

    /// <summary>The luminance of a colour.</summary>
    public static float Luminance(Vector3 color) => Vector3.Dot(color, new(0.2126f, 0.7152f, 0.0722f));
}

/// <summary>What a filter goes by, beside the light: the things, normals and distances of the pixels, laid out as <see cref="MovingPlanes"/>.</summary>
internal sealed class MovingGuides
{
    /// <summary>Makes room.</summary>
    /// <param name="like">Planes of the same size.</param>
    public MovingGuides(MovingPlanes like)
    {
        (Thing, NormalX, NormalY, NormalZ, Depth) = (new int[like.Size], new float[like.Size], new float[like.Size], new float[like.Size], new float[like.Size]);
        Array.Fill(Thing, -1);
    }

    /// <summary>The thing's number; −1 beside the rows.</summary>
    public int[] Thing { get; }

    /// <summary>The unit normal's x; zero where nothing is seen.</summary>
    public float[] NormalX { get; }

    /// <summary>The unit normal's y.</summary>
    public float[] NormalY { get; }

    /// <summary>The unit normal's z.</summary>
    public float[] NormalZ { get; }

    /// <summary>The logarithm of the distance, which a plane seen from anywhere changes slowly.</summary>
    public float[] Depth { get; }
}
