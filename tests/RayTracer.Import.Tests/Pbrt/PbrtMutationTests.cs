using System.Diagnostics;
using System.Text;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

[Trait("Category", "Thorough")]
public class PbrtMutationTests
{
    private const string Scene = """
        Scale -1 1 1 LookAt 0 2 6 0 1 0 0 1 0 Camera "perspective" "float fov" 45 "float screenwindow" [-1 1 -1 1]
        Film "rgb" "integer xresolution" 8 "integer yresolution" 8 "float iso" 200 PixelFilter "mitchell" Sampler "halton" Integrator "path" "integer maxdepth" 3
        Option "bool disablepixeljitter" true ColorSpace "rec2020"
        WorldBegin
        LightSource "spot" "blackbody I" 3200 "float power" 3 LightSource "infinite" "spectrum L" [400 1 700 2]
        Texture "t" "spectrum" "checkerboard" "rgb tex1" [1 0 0] Texture "m" "float" "mix" "float tex1" 0.1 "float amount" 0.5
        MakeNamedMedium "fog" "string type" "uniformgrid" "integer nx" 2 "integer ny" 2 "integer nz" 2 "float density" [1 2 3 4 5 6 7 8]
        MakeNamedMaterial "a" "string type" "diffuse" "texture reflectance" "t"
        Material "mix" "string materials" ["a" "a"] "texture amount" "m"
        AttributeBegin Attribute "shape" "float alpha" 0.5 Translate 1 0 0 Rotate 30 0 1 0 Shape "disk" "float innerradius" 0.2 ReverseOrientation Shape "cylinder" "float phimax" 20 AttributeEnd
        ObjectBegin "o" Shape "sphere" "float zmax" 0.5 "float phimax" 30 ObjectEnd ObjectInstance "o" # comment
        AttributeBegin MediumInterface "fog" "" Material "interface" Shape "sphere" AttributeEnd
        Texture "noise" "float" "fbm" "integer octaves" 3 Texture "dots" "spectrum" "dots" "rgb inside" [1 0 0]
        MakeNamedMedium "dye" "string type" "rgbgrid" "integer nx" 2 "rgb sigma_a" [1 2 3 4 5 6] MakeNamedMedium "cloud" "string type" "cloud" "float wispiness" 0.5
        AttributeBegin TransformTimes 0 1 ActiveTransform EndTime Translate 1 0 0 ActiveTransform All Material "coatedconductor" "float conductor.roughness" 0.1
        Shape "curve" "string basis" "bspline" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 0 2 0 1] "float width" 0.1
        Shape "curve" "string type" "ribbon" "integer degree" 2 "point3 P" [0 0 0 1 0 0 0 1 0] "normal N" [0 0 1 0 1 0] AttributeEnd
        Material "coateddiffuse" "float thickness" 0.02 AreaLightSource "diffuse" "rgb L" [1 2 3] "float power" 2
        Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 0] "integer indices" [0 1 2 1 3 2] "normal N" [0 0 1 0 0 1 0 0 1 0 0 1] "point2 uv" [0 0 1 0 0 1 1 1]
        """;

    private static readonly string[] s_pieces =
        ["\"", "[", "]", " 1e38 ", " -1 ", " 0 ", " nan ", " 99999999999 ", "AttributeBegin ", "AttributeEnd ", "ObjectBegin \"o\" ", "ObjectEnd ", "Include \"scene.pbrt\" ", "WorldBegin ",
        "\"float scale\" ", "\"texture tex1\" \"t\" ", "\"string type\" \"mix\" ", "Identity ", "Transform [0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1] ", "\0", "\uFFFD", "#"];

    [Fact]
    public void Damaged_scenes_are_read_or_refused()
    {
        using PbrtTestScene folder = new();
        Random random = new(2009 + TestSettings.Seed);
        int rounds = TestSettings.Scale(200, 5000);
        int refused = 0;
        File.WriteAllText(folder["scene.pbrt"], Scene);
        Assert.NotNull(SceneLoader.Load(folder["scene.pbrt"]).Scene);
        for (int round = 0; round < rounds; round++)
        {
            string damaged = Damage(random);
            File.WriteAllText(folder["scene.pbrt"], damaged);
            long before = GC.GetAllocatedBytesForCurrentThread();
            Stopwatch watch = Stopwatch.StartNew();
            SceneLoadResult load = SceneLoader.Load(folder["scene.pbrt"]);
            refused += load.Scene is null ? 1 : 0;
            Assert.Equal(load.Diagnostics.Any(d => d.Severity == Severity.Error), load.Scene is null);
            Assert.All(load.Diagnostics, d => Assert.DoesNotContain('\n', d.Message));
            Assert.True(watch.Elapsed.TotalSeconds < 5 && GC.GetAllocatedBytesForCurrentThread() - before < 1L << 30, damaged);
        }

        Assert.InRange(refused, rounds / 5, rounds - (rounds / 100));
    }

    private static string Damage(Random random)
    {
        StringBuilder text = new(Scene);
        for (int change = random.Next(4); change >= 0; change--)
        {
            int at = random.Next(text.Length);
            switch (random.Next(5))
            {
                case 0:
                    text.Remove(at, Math.Min(random.Next(20), text.Length - at));
                    break;
                case 1:
                    text.Insert(at, text.ToString(at, Math.Min(random.Next(40), text.Length - at)));
                    break;
                case 2:
                    text[at] = (char)random.Next(32, 127);
                    break;
                case 3 when random.Next(4) == 0:
                    text.Length = at + 1;
                    break;
                default:
                    text.Insert(at, s_pieces[random.Next(s_pieces.Length)]);
                    break;
            }
        }

        return text.ToString();
    }
}
