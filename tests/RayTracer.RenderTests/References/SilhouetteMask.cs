using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.RenderTests.References;

/// <summary>
/// Pixels in which surfaces of interpolated normals are seen edge on. Where such a normal is turned away from the ray, this renderer takes
/// its other side, and the other one lights the surface from behind: neither is what a surface does.
/// </summary>
public sealed class SilhouetteMask
{
    private const int Reach = 2;
    private const float LeastCosine = 0.45f;

    private readonly bool[] _isMasked;

    private SilhouetteMask(bool[] isMasked) => _isMasked = isMasked;

    /// <summary>How much of the picture is masked.</summary>
    public double Share => _isMasked.Count(m => m) / (double)_isMasked.Length;

    /// <summary>The mask of a scene file with a perspective camera.</summary>
    public static SilhouetteMask Of(string file)
    {
        CameraDescription camera = new();
        Scene scene = SceneRuns.Load(file, d =>
        {
            camera = d.Camera;
            return d with { Render = d.Render with { Integrator = Integrator.Normals, SamplesPerPixel = 16 } };
        });
        Film film = new RTracer(scene).Render().Film;
        Vector3[] normals = Normals(film);
        bool[] isEdge = new bool[normals.Length];
        for (int i = 0; i < normals.Length; i++)
        {
            Vector3 view = Direction(camera, (i % film.Width) + 0.5f, (i / film.Width) + 0.5f, film.Width, film.Height);
            isEdge[i] = IsCurved(normals, i, film.Width) && -normals[i].Dot(view) < LeastCosine;
        }

        return new([.. Enumerable.Range(0, isEdge.Length).Select(i => Around(i, film.Width, film.Height, Reach).Any(j => isEdge[j]))]);
    }

    /// <summary>Images with the reference in place of what is masked.</summary>
    public ImageSamples Apply(ImageSamples images, Picture reference)
    {
        ImageSamples masked = new(images.Width, images.Height);
        for (int image = 0; image < images.Count; image++)
        {
            Picture picture = new(images.Width, images.Height);
            for (int i = 0; i < picture.Pixels.Length; i++)
            {
                picture.Pixels[i] = _isMasked[i / 3] ? reference.Pixels[i] : images.Value(image, i);
            }

            masked.Add(picture);
        }

        return masked;
    }

    private static Vector3[] Normals(Film film)
    {
        Vector3[] normals = new Vector3[film.Width * film.Height];
        float[] row = new float[3 * film.Width];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, row);
            for (int x = 0; x < film.Width; x++)
            {
                normals[(y * film.Width) + x] = (2 * new Vector3(row[3 * x], row[(3 * x) + 1], row[(3 * x) + 2])) - Vector3.One;
            }
        }

        return normals;
    }

    private static bool IsCurved(Vector3[] normals, int at, int width) =>
        Around(at, width, normals.Length / width, 1).Any(j => (normals[j] - normals[at]).Norm() > 1e-3f);

    private static IEnumerable<int> Around(int at, int width, int height, int reach) =>
        from y in Enumerable.Range((at / width) - reach, (2 * reach) + 1)
        from x in Enumerable.Range((at % width) - reach, (2 * reach) + 1)
        where x >= 0 && x < width && y >= 0 && y < height
        select (y * width) + x;

    private static Vector3 Direction(CameraDescription camera, float x, float y, int width, int height)
    {
        Vector3 forward = (camera.LookAt - camera.Position).Unit();
        Vector3 right = forward.Cross(camera.Up).Unit();
        float half = (float)Math.Tan(camera.FieldOfView * Math.PI / 360);
        Vector3 across = right * (((2 * x) - width) / width * half);
        return (forward + across + (right.Cross(forward) * ((height - (2 * y)) / width * half))).Unit();
    }
}
