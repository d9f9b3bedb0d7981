-- | The real sky: the stars of the Hipparcos and Bright Star catalogues, and the
-- light of the Milky Way that they leave out.
--
-- @data\/sky\/README.md@ says where both come from, what was done to them, and how the
-- files are coded. Stars and map share one frame, that of "BlackHole.Trace.EnvironmentMap"
-- with the galactic centre in the middle of the picture and the north galactic pole
-- at its upper edge; 'toRealSky' turns directions of the scene into it.
--
-- Everything is in units of the flux of magnitude 0.
module BlackHole.Trace.RealSky
  ( realStars,
    realMilkyWay,
    toRealSky,
    fromEquatorial,

    -- * Decoding
    decodeStars,
    decodeMilkyWay,
    temperatureOfColour,
  )
where

import BlackHole.Light.BlackBodyTable (tabulatedColour)
import BlackHole.Light.Radiance
import BlackHole.Trace.EnvironmentMap
import BlackHole.Trace.Galaxy
import BlackHole.Trace.SkyFiles
import BlackHole.Trace.StarCatalogue
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Unsafe as Bytes (unsafeIndex)
import qualified Data.Vector.Unboxed as U

-- | The 118 235 stars, decoded at the first use.
realStars :: StarCatalogue
realStars = decodeStars starBytes
{-# NOINLINE realStars #-}

-- | The diffuse light: radiance in fluxes of magnitude 0 per steradian. Decoded at
-- the first use.
realMilkyWay :: Maybe EnvironmentMap
realMilkyWay = decodeMilkyWay milkyWayBytes
{-# NOINLINE realMilkyWay #-}

-- | A direction of the scene in the frame of the real sky, which is turned about the
-- axis +y by an angle in radians: a positive one moves the sky from −z towards +x, as
-- 'turned' moves a panorama.
toRealSky :: Double -> XYZ -> XYZ
toRealSky angle = \d -> XYZ (XYZ.dot d east) (XYZ.dot d north) (XYZ.dot d behind)
  where
    -- The axes of that frame in the scene.
    east = turn (fromGalactic (XYZ 0 (-1) 0))
    north = turn (fromGalactic (XYZ 0 0 1))
    behind = turn (fromGalactic (XYZ (-1) 0 0))
    turn (XYZ x y z) = XYZ (c * x - s * z) y (c * z + s * x)
    c = cos angle
    s = sin angle

-- | The direction at a right ascension and declination (ICRS), in radians, in the
-- frame of the real sky.
fromEquatorial :: Double -> Double -> XYZ
fromEquatorial ascension declination =
  equatorialDirection (cos ascension) (sin ascension) (cos declination) (sin declination)

-- | The same, from cosine and sine of both angles. The matrix from ICRS to galactic
-- coordinates is that of ESA 1997, The Hipparcos and Tycho Catalogues, volume 1,
-- section 1.5.3.
equatorialDirection :: Double -> Double -> Double -> Double -> XYZ
equatorialDirection ca sa cd sd = XYZ (negate east) pole (negate centre)
  where
    x = cd * ca
    y = cd * sa
    centre = -0.0548755604 * x - 0.8734370902 * y - 0.4838350155 * sd
    east = 0.4941094279 * x - 0.4448296300 * y + 0.7469822445 * sd
    pole = -0.8676661490 * x - 0.1980763734 * y + 0.4559837762 * sd
{-# INLINE equatorialDirection #-}

-- | The effective temperature in kelvin of a star of colour index B−V
-- (Ballesteros 2012, "New insights into black bodies", equation 14).
temperatureOfColour :: Double -> Double
temperatureOfColour bv = 4600 * (1 / (0.92 * bv + 1.7) + 1 / (0.92 * bv + 0.62))

-- | Decode stars of 8 bytes each; bytes beyond a multiple of 8 are passed over.
-- About 0.1 µs a star.
decodeStars :: Bytes.ByteString -> StarCatalogue
decodeStars bytes = catalogueOf (Bytes.length bytes `quot` 8) $ \i ->
  let byte k = fromIntegral (Bytes.unsafeIndex bytes (8 * i + k)) :: Int
      ascension = 65536 * byte 0 + 256 * byte 1 + byte 2
      declination = 65536 * byte 3 + 256 * byte 4 + byte 5
      magnitude = 4 * byte 6 + byte 7 `quot` 64
      Unit ca sa = sumOf wholeTurn ascension
      -- The declination counts from −90°.
      Unit sd' cd = sumOf halfTurn declination
   in Star
        (equatorialDirection ca sa cd (negate sd'))
        (fromIntegral magnitude / 50 - 2)
        (U.unsafeIndex temperatures (byte 7 `rem` 64))
  where
    temperatures = U.generate 64 (\c -> temperatureOfColour (fromIntegral c / 24.2 - 0.4))
    wholeTurn = angles (2 * pi / 16777216)
    halfTurn = angles (pi / 16777215)

-- | Cosine and sine of an angle.
data Unit = Unit !Double !Double

-- | Cosine and sine of 24-bit angles as sums of two of 12 bits, in the given unit:
-- four multiplications instead of a cosine and a sine.
angles :: Double -> (U.Vector (Double, Double), U.Vector (Double, Double))
angles unit = (table (4096 * unit), table unit)
  where
    table step = U.generate 4096 (\i -> let angle = step * fromIntegral i in (cos angle, sin angle))

sumOf :: (U.Vector (Double, Double), U.Vector (Double, Double)) -> Int -> Unit
sumOf (coarse, fine) n = Unit (c * c' - s * s') (s * c' + c * s')
  where
    (c, s) = U.unsafeIndex coarse (n `quot` 4096)
    (c', s') = U.unsafeIndex fine (n `rem` 4096)
{-# INLINE sumOf #-}

-- | Decode the map of diffuse light: 720 by 360 brightnesses, then 180 by 90 colours.
-- Missing bytes count as 0.
decodeMilkyWay :: Bytes.ByteString -> Maybe EnvironmentMap
decodeMilkyWay bytes = environmentMapFromPixels width height $ \i j ->
  scaleRadiance (U.unsafeIndex brightnesses (byte (width * j + i))) (colourAt i j)
  where
    width = 720
    height = 360
    byte k
      | k < Bytes.length bytes = fromIntegral (Bytes.unsafeIndex bytes k) :: Int
      | otherwise = 0
    -- Stars of magnitude 10 per square degree, as fluxes of magnitude 0 per steradian.
    brightnesses = U.generate 256 $ \n ->
      4 * 10 ** (fromIntegral n / 100) * 1e-4 * (180 / pi) ** 2 :: Double
    -- Linear between the middles of the colours' cells, which are four pixels wide, in
    -- eighths of a cell.
    colourAt i j =
      let (column, right) = (2 * i + 8 * columns - 3) `quotRem` 8
          (row, down) = max 0 (min (8 * (rows - 1)) (2 * j - 3)) `quotRem` 8
          at r c = byte (width * height + columns * min (rows - 1) r + c `rem` columns)
          mixed r = (8 - right) * at r column + right * at r (column + 1)
          eighths = ((8 - down) * mixed row + down * mixed (row + 1)) `quot` 8
          (red, green, blue) = U.unsafeIndex colours eighths
       in Radiance red green blue
    columns = 180
    rows = 90
    -- For every eighth of a code.
    colours = U.generate (8 * 255 + 1) $ \n ->
      let temperature = temperatureOfColour (fromIntegral n / (8 * 170) + 0.2)
          Radiance red green blue = tabulatedColour temperature
       in (red, green, blue)
