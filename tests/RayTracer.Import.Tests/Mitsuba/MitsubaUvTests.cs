using System.Numerics;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>
/// A picture whose colour gives the position in it, on every shape: at each point of the surface it must show what the other renderer's
/// conventions say (as docs/mitsuba.md has them).
/// </summary>
public class MitsubaUvTests
{
    private const int Size = 400;
    private const int Texels = 64;
    private const float Reach = 2;
    private const string Turn = """<transform name="to_world"><rotate x="0.436436" y="0.872872" z="0.218218" angle="40"/></transform>""";

    private static readonly Transform s_turn = Transform.Rotation(new(1, 2, 0.5f), 40);

    private delegate (Vector3 Point, Vector3 Normal) Surface(float u, float v);

    private static readonly Dictionary<string, (string Xml, Surface Surface)> s_shapes = new()
    {
        ["rectangle"] = ("""<shape type="rectangle">""", (u, v) => (new((2 * u) - 1, (2 * v) - 1, 0), Vector3.UnitZ)),
        ["sphere"] = ("""<shape type="sphere"><float name="radius" value="1.5"/>""", (u, v) => (1.5f * OnSphere(u, v), OnSphere(u, v))),
        ["disk"] = ("""<shape type="disk">""", (u, v) => (u * OnCircle(v), Vector3.UnitZ)),
        ["cylinder"] = (
            """<shape type="cylinder"><point name="p0" z="-1"/><point name="p1" z="1"/><float name="radius" value="0.5"/>""",
            (u, v) => ((0.5f * OnCircle(u)) + new Vector3(0, 0, (2 * v) - 1), OnCircle(u))),
        ["cube +x"] = (Cube, (u, v) => (new(1, (2 * u) - 1, 1 - (2 * v)), Vector3.UnitX)),
        ["cube -x"] = (Cube, (u, v) => (new(-1, (2 * u) - 1, (2 * v) - 1), -Vector3.UnitX)),
        ["cube +y"] = (Cube, (u, v) => (new(1 - (2 * u), 1, 1 - (2 * v)), Vector3.UnitY)),
        ["cube -y"] = (Cube, (u, v) => (new((2 * v) - 1, -1, (2 * u) - 1), -Vector3.UnitY)),
        ["cube +z"] = (Cube, (u, v) => (new((2 * v) - 1, (2 * u) - 1, 1), Vector3.UnitZ)),
        ["cube -z"] = (Cube, (u, v) => (new((2 * v) - 1, 1 - (2 * u), -1), -Vector3.UnitZ)),
    };

    public static TheoryData<string> Shapes => new(s_shapes.Keys);

    private static string Cube => """<shape type="cube">""";

    [Theory]
    [MemberData(nameof(Shapes))]
    public void Pictures_lie_on_shapes_as_the_other_renderer_has_them(string name)
    {
        (string xml, Surface surface) = s_shapes[name];
        int seen = 0;

        // From six sides, of which each shows some of the surface.
        foreach (Vector3 from in new[] { Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, -Vector3.UnitX, -Vector3.UnitY, -Vector3.UnitZ })
        {
            Vector3 up = from.Y == 0 ? Vector3.UnitY : Vector3.UnitZ;
            Film film = Render(xml, from, up);
            for (float u = 0.075f; u < 1; u += 0.1f)
            {
                for (float v = 0.075f; v < 1; v += 0.1f)
                {
                    (Vector3 point, Vector3 normal) = surface(u, v);
                    if (s_turn.Vector(normal).Dot(from) > 0.4f)
                    {
                        Rgb color = At(film, s_turn.Point(point), from, up);
                        Assert.True(Math.Abs(color.R - u) < 0.03 && Math.Abs(color.G - v) < 0.03, $"from {from} at uv {u}, {v}: found {color}");
                        seen++;
                    }
                }
            }
        }

        Assert.InRange(seen, 60, 1000);
    }

    // All shapes are convex, so what faces the camera is seen.
    private static Film Render(string shape, Vector3 from, Vector3 up)
    {
        using TestScene scene = new();
        WritePicture(scene["uv.pfm"]);
        string sensor = $"""
            <sensor type="orthographic">
              <transform name="to_world"><scale x="{Reach}" y="{Reach}"/><lookat origin="{5 * from.X}, {5 * from.Y}, {5 * from.Z}" target="0 0 0" up="{up.X}, {up.Y}, {up.Z}"/></transform>
              <film type="hdrfilm"><integer name="width" value="{Size}"/><integer name="height" value="{Size}"/><rfilter type="box"/></film>
            </sensor>
            """;
        string path = scene.Write("scene.xml", $"""
            {shape}{Turn}
              <bsdf type="diffuse">
                <texture type="bitmap" name="reflectance"><string name="filename" value="uv.pfm"/><string name="wrap_mode" value="clamp"/></texture>
              </bsdf>
            </shape>
            """, sensor);
        return new RTracer(SceneRuns.Load(path, d => d with { Render = d.Render with { Integrator = Description.Integrator.Albedo } })).Render().Film;
    }

    // The first row is at v = 0.
    private static void WritePicture(string path)
    {
        Picture picture = new(Texels, Texels);
        for (int i = 0; i < Texels * Texels; i++)
        {
            picture.Pixels[3 * i] = ((i % Texels) + 0.5f) / Texels;
            picture.Pixels[(3 * i) + 1] = ((i / Texels) + 0.5f) / Texels;
        }

        ImageFile.Write(path, picture);
    }

    private static Rgb At(Film film, Vector3 point, Vector3 from, Vector3 up)
    {
        Vector3 right = up.Cross(from).Unit();
        int x = (int)(Size * (1 + (point.Dot(right) / Reach)) / 2);
        int y = (int)(Size * (1 - (point.Dot(up) / Reach)) / 2);
        float[] row = new float[3 * Size];
        film.ReadRow(y, row);
        return new(row[3 * x], row[(3 * x) + 1], row[(3 * x) + 2]);
    }

    private static Vector3 OnCircle(float turn) => new((float)Math.Cos(2 * Math.PI * turn), (float)Math.Sin(2 * Math.PI * turn), 0);

    private static Vector3 OnSphere(float u, float v) =>
        ((float)Math.Sin(Math.PI * v) * OnCircle(u)) + new Vector3(0, 0, (float)Math.Cos(Math.PI * v));
}
