using System.Runtime.CompilerServices;
using RayTracer.Import;

/// <summary>Makes the formats of models and of other renderers' scenes known before any test of an assembly runs.</summary>
internal static class ImportersAtStart
{
    [ModuleInitializer]
    public static void Register() => Importers.Register();
}
