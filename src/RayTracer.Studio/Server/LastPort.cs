using System.Globalization;
using System.Net;
using System.Net.Sockets;
using RayTracer.Session;

namespace RayTracer.Studio;

/// <summary>
/// The port of the last time. A browser keeps what a page stores by its address: at another one, the layout of the window would be
/// forgotten, and what was typed while the Studio was gone would not be found.
/// </summary>
/// <param name="folders">The user's folders.</param>
internal sealed class LastPort(UserFolders folders)
{
    /// <summary>Returns that port if nobody uses it now; else 0, which stands for any free one.</summary>
    public int Free()
    {
        try
        {
            if (int.TryParse(File.ReadAllText(folders.PortFile), NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port is >= 1024 and <= 65535)
            {
                using TcpListener probe = new(IPAddress.Loopback, port);
                probe.Start();
                return port;
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or SocketException)
        {
            // None was kept, or it is taken.
        }

        return 0;
    }

    /// <summary>Keeps a port for the next time.</summary>
    public void Keep(int port)
    {
        try
        {
            File.WriteAllText(folders.PortFile, port.ToString(CultureInfo.InvariantCulture));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Then the next one is another.
        }
    }
}
