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
    /// <param name="why">Why there is none.</param>
    /// <returns>Null where it is missing.</returns>
    public static EmbreePeer? Load(int threads, string settings, out string why)
    {
        string? embree = Find();
        if (embree is null)
        {
            why = "no Embree: neither in PEERS_SITE (see peers/setup.sh) nor as Debian's libembree-dev";
            return null;
        }

        string folder = Directory.CreateTempSubdirectory("raytracer-embree-").FullName;
        string library = Path.Combine(folder, "peer.so");
        string directory = Path.GetDirectoryName(embree)!;
        string source = Path.Combine(AppContext.BaseDirectory, "Embree", "peer.c");
        try
        {
            using Process compiler = Process.Start("gcc", ["-O3", "-mavx2", "-mfma", "-shared", "-fPIC", source, "-o", library, embree, $"-Wl,-rpath,{directory}"]);
            compiler.WaitForExit();
            if (compiler.ExitCode == 0)
            {
                // The wheel's other libraries lie beside it, but the loader does not know.
                foreach (string other in Directory.GetFiles(directory, "libtbb*.so*"))
                {
                    NativeLibrary.Load(other);
                }

                why = embree;
                return new(NativeLibrary.Load(library), folder, threads, settings);
            }

            why = "gcc could not compile the peer";
        }
        catch (Exception e) when (e is System.ComponentModel.Win32Exception or DllNotFoundException)
        {
            why = e.Message;
        }

        Directory.Delete(folder, recursive: true);
        return null;
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

    private static string? Find()
    {
        string? site = Environment.GetEnvironmentVariable("PEERS_SITE");
        string[] folders =
        [
            .. site is null ? [] : new[] { Path.Combine(site, "embreex.libs") },
            Path.Combine(Path.GetTempPath(), "peers-site", "embreex.libs"),
            "/usr/lib/x86_64-linux-gnu",
        ];
        return folders.Where(Directory.Exists).SelectMany(f => Directory.GetFiles(f, "libembree4*.so*").Order(StringComparer.Ordinal)).FirstOrDefault();
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
