-- | Dither: rounding that hides the steps between a display's codes.
--
-- A smooth dark gradient in 8 bits shows its steps as bands. Instead of always
-- rounding at one half, every pixel rounds at a threshold of its own, so that
-- the mean over a small area is the value itself. The thresholds are blue noise:
-- neighbours differ as much as possible, and the eye, which averages fine
-- detail, sees neither grain nor a pattern. What is a code exactly, like black
-- and white, stays as it is.
module BlackHole.Light.Dither
  ( Dither (..),
    ditherThreshold,
    ditherTileSide,
  )
where

import Data.Bits (shiftL, (.&.), (.|.))
import Data.Char (isAsciiLower, isAsciiUpper, isDigit, ord)
import qualified Data.Vector.Unboxed as U
import Data.Word (Word8)

-- | Whether codes of 8 bits are dithered. 16 bits never are: their steps are
-- finer than any display shows.
data Dither
  = -- | Round to the nearest code.
    NoDither
  | -- | Round at thresholds of blue noise.
    BlueNoise
  deriving (Eq, Show, Read, Enum, Bounded)

-- | @ditherThreshold channel column row@: what is added to a value, in codes,
-- before its fraction is cut off. Above 0 and below 1, each of 64 levels equally
-- often in every tile of 'ditherTileSide'. The three channels (0, 1, 2) see the
-- tile shifted against each other, so that their errors do not add up in
-- brightness. Any column and row.
ditherThreshold :: Int -> Int -> Int -> Double
ditherThreshold channel column row = (fromIntegral (U.unsafeIndex tile (y `shiftL` 6 .|. x)) + 0.5) * 0.015625
  where
    x = (column + 21 * channel) .&. (ditherTileSide - 1)
    y = (row + 43 * channel) .&. (ditherTileSide - 1)
{-# INLINE ditherThreshold #-}

-- | Pixels after which the thresholds repeat in either direction.
ditherTileSide :: Int
ditherTileSide = 64

-- | The levels, row by row.
tile :: U.Vector Word8
tile = U.fromListN (ditherTileSide * ditherTileSide) (map (fromIntegral . level) (concat ranks))
{-# NOINLINE tile #-}

-- | 0…63 for the digits of the table below.
level :: Char -> Int
level c
  | isAsciiUpper c = ord c - ord 'A'
  | isAsciiLower c = 26 + ord c - ord 'a'
  | isDigit c = 52 + ord c - ord '0'
  | c == '+' = 62
  | otherwise = 63

-- | Made by the void-and-cluster method (Ulichney 1993) on a torus with a
-- Gaussian of 1.9 pixels, ranks cut to six bits. Below a tenth of a cycle per
-- pixel it has less than a thousandth of white noise's power.
ranks :: [String]
ranks =
  [ "UxBcvDsX8AuI2f7aV8nYSvI3ZA-Xby+YfDWmdvN5CVP6fFi8JUN-fIZl4U+ayObi",
    "Fk3ZQ5INyTg-bsQxhLeEN+mrxSeuNClpQ6I2S+Hhrb1HsXO1mxrH0TNycGotASq9",
    "uP8Lj0pbkFnVLmG3Bkt4qcVGO7pJ6hHTcxsOAkZ3R8uMa5pREb6Cnj9BrgPJ3m1K",
    "0dHrUfB+2vP5D0Yp-PT0iB2gajE2Vr08LiYzpVwLEngBl0KeuhXPwatK1X7veYDg",
    "SWnyE7XSKZrdyjSJcwGZJRy8LwRmdPZtBn-Fb7sezXT-xDU94Ip9dFV6SmDjV-Np",
    "6A+hvOsmhH8BO9fs2W6l9oXsD5YuB+kF4VNgJ1DPkI2cPhYmAOT1L4ipHbyL4Gxb",
    "i2NZJc0Dx3fWlwEMnAfLudHkNfzI3MfySdv5QjT+q6NotHr2byjsBRxeO+rQhtmI",
    "uFpT5j9VMoRtJaU7jQrzDP5Uq+cUoX6Jq2lCtoYcAvZE48LRvGf7YmE2uY3AdT1P",
    "VdlwCQHeZ6G-q04Hxb8TYiw1AQFriCvbPGWa8Fy3LVfjSXfk+WKob-UJkFWo7EZ9",
    "Cz8X1rnuzAciPDgYtKC3o-Jamhw4O9Tls+L0fOJhm09CwzFqO1DvNzqd8MyiOwLg",
    "sRILbg-KSk2VymSp+WflNFetM6ZK1aFzgAjpU4rSuHQoKb5BZi5THhA5SseI+qk4",
    "Nnh7BOWE5pNH6LdBO1GwrS3W8THmfpM7Y2RwHc-Ca6ds-NmTsxcl8tPZnD4a0WGb",
    "-U0up4widtYvbr7zjn6cXzCkqD0tRBwVId6DmzWkxMUiY0g7HLQrXexL0VuPBT2v",
    "AYGcRlZI8QC+jEWvFUQKi9IPydjX95hrmOuZMgPFp4A2IEuV2m+CF3Ik6gHphmKe",
    "r5kJyDM1UngJT3Nga-sA4nfuaM3PEbK1E8Uq92u7YftSkpQdBgZ0To9RBc-Y5t8Q",
    "gM2W+f7rBy4cxoRrJ2ewNZT6B-nJskSZvfjJAdHRKmOy7a9Mzq6OitdWrwLzNDZy",
    "oEvPnTubkXNtH9B0lEpVG1pKiUvf4y+oCQ4znXrj0-cDJgwGkSIwaLD2OmEUekHV",
    "S7dsBiFQK-ElZid6XP8hl+Es0GYQAVHN6WGbOT7wBVq5XTo4WueE8ky7hZ8s3q+1",
    "DjaI3Y6w1eqQ7VLtSyaLucQWel6xqidtkxq-l3EaNhGkt1OEb-P2pVJSGxJiAObK",
    "mz+UyNoHhT5zCw1FjC3I6Bx3M9DbL8R2aKfDuLepz4RxLAi6qKmYA5fupdQ6Xfwt",
    "WPGqfl9WsAaJngOp-ernTgkIoStOn0GC7UP0WiQ9IYdo+aeyUCzhsNX-B3VzoHT6",
    "hdL2CRJc3lMuUY4bJWQwYO8avg1HYfuWnrI8a2FmuC7UFmQIt8cSHwbPnkME9l1B",
    "rx8jvazFPx7i+DlHzh8G0p2EVAj5T-kO4gxmAq6UgO1Kv05XjOo36j0F7ZscvNZJ",
    "nUDXp6h+qXHc0Qs6TuMlCdKsQ+cwqBKybDSdNvYLykqbhNpDxFZLDTqKgxITh2R-",
    "Hb4QIMUCmeSBpLxZkA4b-Si6mzMFQh2YG+tJ5hGc-EW4BT-d2g9ufl+WQ4C8pDey",
    "Otg0let1K4w6gVdFOfqWtHxXfIZn7dsTpj1WzTo3sRI8tlZJRmVPyaBuoe0mLX5j",
    "A3L+Bw5QajOsI2+o70JQm3NCqU3vWEx8LQeCl9PDZmxdPGw5rA1pG4N1HUOawGuV",
    "dqYSobWDqG-XlREuTYx5DhZ90Fh+JOmAav6GbuJj1MgU2niWMb7JeSi8Yks5iR9m",
    "7ExjGO9kyUdAzahMmBicMvodPtkRc1f4iVoMrUye+Aq7KC9yFtjYxsnKwA-EJzZM",
    "0Qf6uK1gIv3oKw5c2I+rU7JT5LBypXrJzF-yhH7WQvGYuQcTg-QC6VDbf3SdogrH",
    "vaJV3dqS7MiQ9UDqQwZE1kAxmeZ7HD+TOmcR3ZlLobzkf1qI3nL0kN+zPqMW2CUj",
    "Bo-lAYFmXbFsfHk8WgpSOfX-G3VshQ3euCYKtB5Es6IS+ElZOvXfpFuXHlt7wO94",
    "ShNrzQw+C04nZv0NF4K6uzbsQj0NwlbL6q81jPwfTiO2WMy6ArG5aSh37CiaFmcX",
    "t1GTb5gMtkTOB-SbjyndClMIoDcJ9EoyWjfGUoc1-FapCthRd8UxJ1mdLU0RJgyK",
    "Ed7vjIpVcKx6dJotAYTH+V4w8T5qXS1AIRNza9IMXtkxe4HYokDi-MBrZxo-s3Q8",
    "qkWLD9O27GhqW2h4P7r2QiEdYguGkfsa7u4lCvSqB4K8UP9zL2OcsWwQ9ENeVBnZ",
    "0O4oyYlBsZREwMDVmJwgav1nNA2QL-3OncFrY7hmydRGnbrDVu6RnG6gIj3bGwiI",
    "UAgRctSfyn3+laz9eFjNBpKR+ylZxCUJhW+QKeE5PY0jAwNlgIZBzkb0qSulL5R9",
    "tx-I1D+HWKOeUHqRvX90U5XjFVre6pivzD1jw2UtIg9s2Xe3+xqf9KUO4AX9rzYd",
    "GlaqiMmv6j1Au5iK3oDcsH8uc4HKTEb8MqTHnNb-CpNTK7HREUM3XvEdnxJPgCoM",
    "1PEV5X2PbDrYnPcCZNySmfPxhMo7zXsGReZ8AgzSkxbEfyptjcnPHjs+Zh7UcG4h",
    "se7vKgpGUxg8Jy-tl6hJ+ZEpC1RgkN2m5wk4tXqK2V5vmWNa06Ax7R1CMGs0kv+S",
    "Y3BmSDze-LR2WEfT1AVu2MzTX-avA+dJWCOKdE6GneBQ-iC4KWreZogV5oR2DOWI",
    "jLcx9sZ4kqHbpjMrIbPnGir5lJrGVxQis-ozRviOZ8LrG0SoGh-FN0JcwkaKeqn7",
    "zpPXjNIRAvi4B7wX9x4e7RbBeP3iLqD1aFgV2m+T0ujcXve8uPTlvD9rPB-U5wbF",
    "uT8F3co7yXNTzQGmgKqEXwI9yuY8c7nTvN7ZBJbDpIS62IMkby2Y5iUH3ftEiMRA",
    "6JfrCvVgKc9nsea3CUkNs1jVMFnTOzYK5lHpyes4WyClPp5WFBqLcQnyYLmzX92g",
    "nZk0R-lEt2ChIL+Suza9TDdp6gBwHjEfycSu9PMkfK+ahAtR3neH7sA8d1QpIdsW",
    "yM4HXLzPpSZ6V0piO5If3nKQza2qe4t9AP3iWF06RvoVx9cJh+O1xWhKvFV6ClPG",
    "SCudoha8HjxFulAYFqmBwY+tHlW-KUQoXrLCnaqAdG3NETmzYvUgENpTkb+huL1+",
    "ib8P5As3Wn+QeN5xdW8RMhF4fSCO0bGwg6zd-xU8Ysi1fuH7MFrlZ-z6CrNSyZep",
    "vFmVxGTNdCKr3aT-K1jub0UrM8unh7lMaITkNHhKlP-JYqQjb1AR3dHPY3oE5UA7",
    "N0Jrf9k0vgzVDiHnsPEJp7DmZcyFXsB3+uDq2Rt4zCSc7yC4Vo9vKsniweItjmJX",
    "dRh2LYoI7RZ9o0vBgZx4eWOxIj5QJzTdQjW5ZFoaVwpFlMhrJeOiXCU0L8Wc-P3r",
    "6B+aDQtcBqkJOdR3V8mSAk9t2BUqf9kGo1Lwg7BeM5gtV2aSy6Gz4f9ESlBMzDgw",
    "lVouj4-OW3F6sW9LqFNszKaRgL+maMtxYAdIlOv9kGQ8KA-uDYmRqMbu5g2voUHZ",
    "3GNyEeHm0iSvfDlah0dX7iFo4XwG1DV7O5r+U0XJrZ0dwjPfnLctGkyPIrYRa9qL",
    "tfS7XrTxDcLYyH5tC-IP3uVyCdsSh4bJmiRaFphR2BnNXp0F83V+B6YodD8Jke1P",
    "8wcmK3hZt4n-jN1QUwjnCeM-kOJ8lPqfEx1tM4Dcx+UE7IbTiwIh0TKi4VysFxCX",
    "nAI0P9BM7IQBUreoZM5aSrIZ6n1WBzv-WLCeYv8lLqifyt5NrCQpaNt+AmOhM5Ti",
    "a+VjucpkVfs1b8EJ2gsF91whTFxfZMHS3k9nIiOVaG5RlDVe2Yl5exG1Sb3Y-cpJ",
    "N4rEYGyRv9GhKwWl+AxWKlPDucL9s6oearUQ50sE2tMY1Kn+GyL8FnhXrIuoBQ1v",
    "fRzgO62LEalzS5juRcOipb8W5qRhEUjA0NFxbBgS-dwA9cPqgStAWQ8Me6E0VlsD",
    "XoJ-nUieo4OXpCNFq1H6zCfMjzHn2PvK4ti8KpXymJjoTzvCZ4kcv2pDwRjLf7H5"
  ]
