namespace RayTracer.Import;

/// <summary>What Mitsuba has and this reader refuses, by kind and type, with the reason.</summary>
internal static class MitsubaPlugins
{
    /// <summary>The reasons.</summary>
    public static IReadOnlyDictionary<(string Kind, string Type), string> Refused { get; } = """
        shape bsplinecurve: bent curves are not rendered, and "linearcurve" is read
        shape sdfgrid: surfaces of distance fields are not rendered
        shape heightfield: a mesh of the same heights is
        shape ellipsoids: splats are not rendered
        shape ellipsoidsmesh: splats are not rendered
        shape blender: its meshes lie in the memory of another program
        bsdf hair: light within hairs is not simulated
        bsdf measured: measured tables are not read
        bsdf measured_polarized: light has no polarisation here
        bsdf polarizer: light has no polarisation here
        bsdf retarder: light has no polarisation here
        bsdf circular: light has no polarisation here
        bsdf pplastic: light has no polarisation here, and "roughplastic" is the same without
        texture volume: volumes fill shapes only
        emitter sunsky: its sky is a table of numbers, which the native "sky" computes otherwise; a picture of it in an "envmap" is read
        emitter timed_sunsky: its sky is a table of numbers, which the native "sky" computes otherwise; a picture of it in an "envmap" is read
        emitter directionalarea: its light has no spread
        sensor batch: a scene has one camera
        sensor distant: its film is no picture
        sensor irradiancemeter: its film is no picture
        sensor radiancemeter: its film is no picture
        integrator depth: distances are an auxiliary image, --aov depth
        integrator stokes: light has no polarisation here
        film specfilm: pictures have red, green and blue
        rfilter lanczos: "catmullrom" and "mitchell" are as sharp
        """.Split(['\n', '\r'], StringSplitOptions.RemoveEmptyEntries).Select(line => line.Split([' ', ':'], 3))
        .ToDictionary(words => (words[0], words[1]), words => words[2].Trim());

    /// <summary>What stands in for a thing of a kind, as the end of a sentence.</summary>
    public static string StandInOf(string kind) => kind switch
    {
        "bsdf" or "texture" => "magenta is shown instead",
        "shape" => "a magenta ball is shown instead",
        "integrator" => "\"path\" is used instead",
        "sensor" => "a perspective one is used instead",
        "emitter" or "medium" or "phase" => "it is left out",
        _ => "the default is used instead",
    };

    /// <summary>The reason why a thing is refused, as the end of a sentence; null where its type is none of Mitsuba's.</summary>
    public static string? ReasonOf(MitsubaObject thing) => Refused.GetValueOrDefault((thing.Kind, thing.Type));
}
