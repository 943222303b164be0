using System.Numerics;
using RayTracer.Textbook;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.Study;

/// <summary>An eye above the landscape, and the picture that it sees: square, of triangles in front of it alone.</summary>
internal static class TerrainView
{
    private const double Window = 0.9;
    private const double Near = 0.01;
    private const double Far = 10;
    private static readonly Vector s_eye = new(0.5, 0.55, -0.45);
    private static readonly Vector s_forward = new Vector(0, -0.45, 1).Unit;
    private static readonly Vector s_right = new(-1, 0, 0);
    private static readonly Vector s_up = Vector.Cross(s_right, s_forward);

    /// <summary>The matrix of view and projection.</summary>
    public static Matrix Camera { get; } = Matrix.Perspective(Window, Window, Near, Far).After(Matrix.View(s_eye, s_right, s_up, s_forward));

    /// <summary>The ray through the middle of a pixel.</summary>
    /// <param name="pixel">Its number, row by row from the top left.</param>
    /// <param name="side">Width and height of the picture.</param>
    public static (Vector3 Origin, Vector3 Direction) RayOf(int pixel, int side)
    {
        double x = (((pixel % side) + 0.5) / side) - 0.5;
        double y = 0.5 - (((pixel / side) + 0.5) / side);
        Vector d = (s_forward + (s_right * (Window * x)) + (s_up * (Window * y))).Unit;
        return (new((float)s_eye.X, (float)s_eye.Y, (float)s_eye.Z), new((float)d.X, (float)d.Y, (float)d.Z));
    }
}
