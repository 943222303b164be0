using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text;

namespace RayTracer.Benchmarks.Embree;

/// <summary>Embree, through a small C library that is compiled when the benchmark runs.</summary>
internal sealed unsafe class EmbreePeer : IDisposable
{
    private readonly nint _library;
    private readonly string _folder;
    private readonly void* _device;
    private readonly delegate* unmanaged<void*, float**, float*, int*, int, int, int, int, void> _trace1;
    private readonly delegate* unmanaged<void*, float**, float*, int*, int, int, int, int, void> _trace8;

    private EmbreePeer(nint library, string folder, int threads, string settings)
    {
        _library = library;
        _folder = folder;
        _trace1 = (delegate* unmanaged<void*, float**, float*, int*, int, int, int, int, void>)NativeLibrary.GetExport(library, "peer_trace1");
        _trace8 = (delegate* unmanaged<void*, float**, float*, int*, int, int, int, int, void>)NativeLibrary.GetExport(library, "peer_trace8");
        var device = (delegate* unmanaged<byte*, void*>)NativeLibrary.GetExport(library, "peer_device");
        fixed (byte* text = Encoding.UTF8.GetBytes($"threads={threads}{settings}\0"))
        {
            _device = device(text);
        }
    }

    /// <summary>Embree's version.</summary>
    public string Version
    {
        get
        {
            long version = ((delegate* unmanaged<void*, long>)NativeLibrary.GetExport(_library, "peer_version"))(_device);
            return $"{version / 10000}.{version / 100 % 100}.{version % 100}";
        }
    }

    /// <summary>Loads the peer.</summary>
    /// <param name="threads">Threads that it builds with.</param>
    /// <param name="settings">Further settings of its device, each with a comma before it.</param>
    /// <param name="why">Where it comes from, or why there is none.</param>
    /// <returns>Null where it is missing.</returns>
    public static EmbreePeer? Load(int threads, string settings, out string why)
    {
        string folder = Directory.CreateTempSubdirectory("raytracer-embree-").FullName;
        try
        {
            if (EmbreeLibrary.Find(folder) is not EmbreeLibrary embree)
            {
                why = "no Embree: no PEERS_SITE (see peers/setup.sh), no wheel in shared/peers/wheels, and no libembree-dev";
            }
            else if (Compile(embree, folder) is not string library)
            {
                why = "gcc could not compile the peer";
            }
            else
            {
                // The wheel's other libraries lie beside it, but the loader does not know.
                foreach (string other in Directory.GetFiles(Path.GetDirectoryName(embree.Path)!, "libtbb-*.so*"))
                {
                    NativeLibrary.Load(other);
                }

                why = embree.Label;
                return new(NativeLibrary.Load(library), folder, threads, settings);
            }
        }
        catch (Exception e) when (e is System.ComponentModel.Win32Exception or DllNotFoundException or InvalidDataException)
        {
            why = e.Message;
        }

        Directory.Delete(folder, recursive: true);
        return null;
    }

    private static string? Compile(EmbreeLibrary embree, string folder)
    {
        string library = Path.Combine(folder, "peer.so");
        string source = Path.Combine(AppContext.BaseDirectory, "Embree", "peer.c");
        using Process compiler = Process.Start("gcc",
        [
            "-O3", "-mavx2", "-mfma", "-shared", "-fPIC", $"-DEMBREE={embree.Major}", source, "-o", library,
            embree.Path, $"-Wl,-rpath,{Path.GetDirectoryName(embree.Path)}",
        ]);
        compiler.WaitForExit();
        return compiler.ExitCode == 0 ? library : null;
    }

    /// <summary>Builds a scene.</summary>
    public Scene Build(BenchmarkMesh mesh, bool robust)
    {
        var build = (delegate* unmanaged<void*, float*, long, int*, long, int, double*, long*, void*>)NativeLibrary.GetExport(_library, "peer_build");
        double seconds;
        long bytes;
        void* scene = build(_device, (float*)mesh.Positions, mesh.PositionCount, mesh.Indices, mesh.TriangleCount, robust ? 4 : 0, &seconds, &bytes);
        return new(this, scene, seconds, bytes);
    }

    public void Dispose()
    {
        ((delegate* unmanaged<void*, void>)NativeLibrary.GetExport(_library, "peer_release_device"))(_device);
        NativeLibrary.Free(_library);
        Directory.Delete(_folder, recursive: true);
    }

    /// <summary>A scene of the peer.</summary>
    internal sealed class Scene(EmbreePeer peer, void* scene, double seconds, long bytes) : IDisposable
    {
        private readonly void* _scene = scene;

        public double Seconds => seconds;

        public long Bytes => bytes;

        /// <summary>Traces some rays, one by one or in packets of eight.</summary>
        public void Trace(BenchmarkRays rays, int first, int count, bool packets, float* distance, int* primitive)
        {
            float** arrays = stackalloc float*[7];
            for (int i = 0; i < 7; i++)
            {
                arrays[i] = rays.Numbers[i].Pointer;
            }

            (packets ? peer._trace8 : peer._trace1)(_scene, arrays, distance, primitive, first, count, rays.Any ? 1 : 0, rays.Coherent ? 1 : 0);
        }

        public void Dispose() => ((delegate* unmanaged<void*, void>)NativeLibrary.GetExport(peer._library, "peer_release"))(_scene);
    }
}
