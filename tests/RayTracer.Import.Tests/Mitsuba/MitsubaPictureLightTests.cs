using System.Numerics;
using System.Text;
using RayTracer.Import;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>
/// Lights that throw pictures, against numbers that Mitsuba 3.9.1 gave for the same lights: what arrives at points, times the squared distance, for a picture of
/// 4 × 2 pixels, of which that of row j and column i is (j + 1, i + 1, 10 j + i).
/// Covers `ProjectorLight`, `PicturePlane`.
/// </summary>
public class MitsubaPictureLightTests
{
    private const string Bitmap = """type="bitmap"><string name="filename" value="picture.pfm"/><boolean name="raw" value="true"/><string name="filter_type" value="nearest"/></texture>""";
    private const string Place = """<transform name="to_world"><lookat origin="0, 0, 0" target="0, 0, 1" up="0, 1, 0"/></transform>""";

    [Theory]
    [InlineData(0.01, 0.01, 1, 3.14191, 6.28381, 3.14191)]
    [InlineData(0.3, 0.1, 1, 3.29493, 3.29493, 0)]
    [InlineData(-0.3, 0.1, 1, 3.29493, 13.1797, 9.88479)]
    [InlineData(0.3, -0.1, 1, 6.58986, 3.29493, 32.9493)]
    [InlineData(0.02, 0.02, 2, 0.785477, 1.57095, 0.785477)]
    [InlineData(0.1, 0.26, 1, 3.26121, 6.52242, 3.26121)]
    [InlineData(0.1, 0.3, 1, 0, 0, 0)]
    [InlineData(0.55, 0.1, 1, 3.59915, 3.59915, 0)]
    [InlineData(0.59, 0.1, 1, 0, 0, 0)]
    public void A_projector_throws_what_Mitsubas_does(float x, float y, float z, float r, float g, float b) =>
        Check($"<emitter type=\"projector\"><texture name=\"irradiance\" {Bitmap}<float name=\"fov\" value=\"60\"/>{Place}</emitter>", new(x, y, z), new(r, g, b));

    [Theory]
    [InlineData(0.01, 0.01, 1, 1.9996, 2.9994, 11.9976)]
    [InlineData(0.3, 0.1, 1, 1.81818, 3.63636, 11.8182)]
    [InlineData(-0.3, 0.1, 1, 1.81818, 0.909091, 9.09091)]
    [InlineData(-0.3, -0.1, 1, 0.909091, 0.909091, 0)]
    [InlineData(0.02, 0.02, 2, 0.4999, 0.74985, 2.9994)]
    [InlineData(0.55, 0.1, 1, 1.21002, 2.42004, 7.86514)]
    [InlineData(0.59, 0.1, 1, 0, 0, 0)]
    public void A_spot_has_its_picture_as_Mitsubas_has(float x, float y, float z, float r, float g, float b) =>
        Check($"<emitter type=\"spot\"><texture name=\"texture\" {Bitmap}<float name=\"cutoff_angle\" value=\"30\"/><float name=\"beam_width\" value=\"29\"/>{Place}</emitter>", new(x, y, z), new(r, g, b));

    private static void Check(string emitter, Vector3 from, Rgb expected)
    {
        using TestScene scene = new();
        using (FileStream file = File.Create(scene["picture.pfm"]))
        {
            file.Write(Encoding.ASCII.GetBytes("PF\n4 2\n-1.0\n"));
            foreach (int row in new[] { 1, 0 })
            {
                for (int column = 0; column < 4; column++)
                {
                    Array.ForEach([row + 1f, column + 1f, (10f * row) + column], n => file.Write(BitConverter.GetBytes(n)));
                }
            }
        }

        SceneLoadResult loaded = SceneLoader.Load(scene.Write("scene.xml", emitter));
        Assert.Equal("", Diagnostic.Format([.. loaded.Diagnostics]));
        LightSource light = Assert.Single(loaded.Scene!.Lights);
        light.Sample(from, 0f, 0f, 0f, out ShapeSampleW _, out RgbW radiance);
        Assert.Equal(expected.R, radiance.R[0], 1e-4f * (1 + expected.R));
        Assert.Equal(expected.G, radiance.G[0], 1e-4f * (1 + expected.G));
        Assert.Equal(expected.B, radiance.B[0], 1e-4f * (1 + expected.B));
    }
}
